// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

namespace twinray {

/// What one query, or the sum of many, did. Boxes and nodes belong to the hand-written trees; primitives are
/// those whose own test ran: by the canonical counting traversal, or by our leaf inside of Embree. The counts
/// of bvh and brute force are the same on every machine. Those of embree are not: which leaves are tested
/// depends on the tree and the traversal of Embree, on its version and instruction set.
struct QueryCounts {
  std::uint64_t nodes = 0;       ///< Inner nodes whose children were looked at.
  std::uint64_t boxes = 0;       ///< Boxes tested.
  std::uint64_t leaves = 0;      ///< Leaves whose primitives were tested.
  std::uint64_t primitives = 0;  ///< Triangles and spheres tested.
  std::uint64_t instances = 0;   ///< Instances in whose trees the ray was traced.

  QueryCounts& operator+=(const QueryCounts& other) {
    nodes += other.nodes;
    boxes += other.boxes;
    leaves += other.leaves;
    primitives += other.primitives;
    instances += other.instances;
    return *this;
  }
  friend bool operator==(const QueryCounts&, const QueryCounts&) = default;
};

}  // namespace twinray

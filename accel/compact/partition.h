// SPDX-License-Identifier: Apache-2.0
// Private: primitives divided into parts that are built one after the other, so that a build takes little
// memory: what is in the making is a part, and what is finished is compact.
#pragma once
#include <cstddef>
#include <vector>

#include "accel/build/binary_tree.h"

namespace twinray {

/// Parts of an array of primitives, and the tree above them.
struct Partition {
  struct Part {
    std::size_t first = 0, count = 0;
  };
  std::vector<Part> parts;  ///< In the order of the array.
  /// Its leaves hold one part each, by number; it has max_part_depth levels at most.
  BuildTree tree;
};

/// Reorders the primitives, of which there are some, and divides them as a builder divides nodes, until no
/// part has more than the larger of a sixteenth of all and `least` of them, which is not below
/// options.max_leaf_size. Large primitives, such as a room's walls, are parts of their own.
Partition partition(BuildPrimitives& primitives, const BuildOptions& options, std::size_t least);

/// A part's primitives; the memory that they had in the array goes back to the system.
BuildPrimitives take_part(BuildPrimitives& primitives, const Partition::Part& part);

}  // namespace twinray

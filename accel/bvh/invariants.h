// SPDX-License-Identifier: Apache-2.0
// Private: what is true of every finished tree, for the tests.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "accel/bvh/node.h"
#include "core/geometry.h"

namespace twinray {

/// Whether boxes together cover another one as a ray needs it (accel/embree/builder.cpp): it lies in one of
/// them, or is cut by a plane of one of them into two parts that are both covered.
bool is_covered(const Aabb& box, std::span<const Aabb> boxes);

/// How often a primitive lies in a tree.
enum class Occurrence {
  once,      ///< In one leaf, whose box holds all of it.
  in_pieces  ///< In one or more leaves, whose boxes cover it.
};

/// In the boxes of which leaves the primitives of a geometry are found, for trees of any width.
class LeavesOfPrimitives {
 public:
  explicit LeavesOfPrimitives(const Geometry& geometry);
  /// What is wrong with this id; empty where nothing is.
  std::string add(PrimitiveId id, const Aabb& leaf);
  /// What is wrong with the first primitive that does not lie in leaves as it should; empty where all do.
  std::string fault(Occurrence occurrence) const;

 private:
  const Geometry& geometry_;
  std::vector<std::vector<std::vector<Aabb>>> boxes_;
};

/// What is wrong with a tree over a geometry, in one sentence; empty where all holds: every primitive, with
/// the widening of padded(), lies in leaves as often as it should, no leaf holds more than max_leaf_size,
/// each box contains those of its children, and no leaf is deeper than max_bvh_depth.
std::string find_fault(const Bvh& bvh, const Geometry& geometry, int max_leaf_size,
                       Occurrence occurrence = Occurrence::once);

}  // namespace twinray

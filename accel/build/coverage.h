// SPDX-License-Identifier: Apache-2.0
// Private: whether the leaves of a tree of any width hold all primitives, for the tests.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "accel/canonical/shape_test.h"
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

}  // namespace twinray

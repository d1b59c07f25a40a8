// SPDX-License-Identifier: Apache-2.0
// Private: the surface area heuristic (MacDonald and Booth, "Heuristics for Ray Tracing Using Space
// Subdivision", 1990): a ray that intersects a convex box intersects a box inside it with the ratio of their
// areas as probability.
#pragma once
#include <bit>
#include <cstddef>

#include "accel/build_options.h"
#include "core/aabb.h"

namespace twinray {

class CostModel {
 public:
  explicit CostModel(const BuildOptions& options)
      : traversal_(options.traversal_cost),
        intersection_(options.intersection_cost),
        block_(std::size_t(options.leaf_block)),
        shift_(std::has_single_bit(block_) ? std::countr_zero(block_) : -1) {}

  /// As how many primitives so many count: a block that is not full takes as long as a full one.
  std::size_t counted(std::size_t primitives) const {
    const std::size_t most = primitives + block_ - 1;
    return shift_ >= 0 ? most >> shift_ << shift_ : most / block_ * block_;  // Divisions are slow.
  }
  double leaf(std::size_t primitives) const { return intersection_ * double(counted(primitives)); }
  /// The cost of a box with area `area` and two leaves: `weighted_area` is the sum of their areas times their
  /// counts. Inside of a box without area every child is intersected.
  double split(double area, double weighted_area, std::size_t primitives) const {
    return traversal_ + (area > 0 ? intersection_ * (weighted_area / area) : leaf(primitives));
  }
  double traversal() const { return traversal_; }

 private:
  double traversal_, intersection_;
  std::size_t block_;
  int shift_;  ///< The binary logarithm of block_ where it is a power of two.
};

}  // namespace twinray

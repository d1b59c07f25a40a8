// SPDX-License-Identifier: Apache-2.0
// Engines with one planted defect: what a crosscheck must find. Most are a plain BVH of their own.
#pragma once
#include <memory>
#include <vector>

#include "accel/accelerator.h"

namespace twinray::test {

enum class Defect {
  none,
  box_rounds_inward,      ///< Boxes shrink by 10^-6 of their size, as if they were rounded the wrong way.
  flipped_comparison,     ///< Of hits with equal t the greatest id wins.
  skipped_child,          ///< One inner node never visits its second child.
  right_never_looked_at,  ///< any-hit: once the left child was visited, whatever it found, the right is not.
  t_max_lags,             ///< A farther hit replaces a nearer one when it comes later.
  last_primitive_lost,    ///< The last primitive is in no leaf.
  minus_zero_ignored,     ///< The octant is chosen by d < 0, so -0.0 counts as positive.
  equal_node_culled,      ///< A node that is entered exactly at t_max, or the best t so far, is culled.
  embree_bounds_unpadded  ///< No plain BVH, but the engine `embree` with boxes that are not widened.
};

/// All of this build: the last one only with Embree.
std::vector<Defect> all_defects();

/// The defect's name, for messages.
const char* defect_name(Defect defect);

std::unique_ptr<Accelerator> build_wrong_engine(std::shared_ptr<const Geometry> geometry, Defect defect);

}  // namespace twinray::test

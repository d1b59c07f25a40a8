// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <limits>

#include "core/vec.h"

namespace twinray {

/// The points origin + t direction for t in the closed interval [t_min, t_max].
///
/// The direction need not be a unit vector: t is a parameter, not a distance. Valid is a ray with a finite
/// origin of components up to 2^60, a finite direction that is not zero, and 0 <= t_min <= t_max (t_min
/// is finite, t_max may be infinite). An invalid ray is a miss on every accelerator. The struct may grow:
/// fill it by designated initialisers.
struct Ray {
  Vec3 origin;
  Vec3 direction;
  float t_min = 0;
  float t_max = std::numeric_limits<float>::infinity();
};

}  // namespace twinray

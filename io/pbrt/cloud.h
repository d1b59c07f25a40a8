// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/aabb.h"
#include "core/density_grid.h"

namespace twinray {

/// pbrt-v4's cloud: noise whose density falls with the height y.
struct PbrtCloud {
  float density = 1;
  float wispiness = 1;  ///< How far the edges are torn apart.
  float frequency = 5;  ///< Of the largest waves of noise, per unit of length.

  /// In [0, 1]; of a point in the space of the statement.
  float at(const Vec3& p) const;
};

/// The cloud within a box, by a grid of up to 192 cells along an edge; finer waves are smoothed out.
/// `to_unit` is that of DensityGrid. Throws Error.
DensityGrid cloud_grid(const PbrtCloud& cloud, const Aabb& box, const Transform& to_unit);

}  // namespace twinray

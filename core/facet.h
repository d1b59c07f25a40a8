// SPDX-License-Identifier: Apache-2.0
// What all points of a triangle have in common: worked out for each hit, which takes no longer than to read
// 16 bytes for each triangle from memory, and needs none.
#pragma once
#include "core/area_vector.h"
#include "core/offset.h"
#include "core/vec.h"

namespace twinray {

struct Facet {
  Vec3 normal;       ///< Unit, out of the triangle's front; of one without area, NaNs.
  float offset = 0;  ///< How far along the normal a ray must start to leave it (core/offset.h).

  Facet(const Vec3& a, const Vec3& b, const Vec3& c)
      : normal(AreaVector(a, b, c).normal()), offset(triangle_offset(a, b, c)) {}
};

}  // namespace twinray

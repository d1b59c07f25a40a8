// SPDX-License-Identifier: Apache-2.0
// Private: boxes for Embree's user geometry.
#pragma once
#include "accel/embree/api.h"
#include "core/aabb.h"
#include "core/geometry.h"

namespace twinray::embree {

/// How far from the coordinate origin a ray may start, in units of the scene's largest coordinate, so that
/// widened() loses none of its hits.
inline constexpr float reach = 7;

/// The largest absolute coordinate of a scene; of an empty one, 0.
inline float scene_size(const Geometry& geometry) {
  const Aabb& box = geometry.bounds();
  return box.is_empty() ? 0 : std::max(max_abs(box.lower), max_abs(box.upper));
}

/// A box that Embree's box test of user geometry, which allows for no rounding, meets wherever the canonical
/// test accepts a hit inside.
///
/// With u = 2^-24, A the scene's size and O <= reach A the origin's largest coordinate: the canonical test
/// sees the shape moved by up to 6 u (A + O); Embree sees a plane up to 7 u (A + O) beside its place (4 u by
/// the approximate reciprocal, 1 u each by the difference, the product and the origin's product). The box
/// grows by 16 u (A + reach A).
inline RTCBounds widened(const Aabb& box, float scene_size) {
  const float pad = scene_size * (1 + reach) * 0x1p-20f;
  RTCBounds bounds;
  bounds.lower_x = box.lower.x - pad;
  bounds.lower_y = box.lower.y - pad;
  bounds.lower_z = box.lower.z - pad;
  bounds.align0 = 0;
  bounds.upper_x = box.upper.x + pad;
  bounds.upper_y = box.upper.y + pad;
  bounds.upper_z = box.upper.z + pad;
  bounds.align1 = 0;
  return bounds;
}

}  // namespace twinray::embree

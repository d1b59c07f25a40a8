// SPDX-License-Identifier: Apache-2.0
// Private: what Embree is given more than there is, because its box test of user geometry allows for no
// rounding, neither its own nor that of the canonical tests.
#pragma once
#include <algorithm>

#include "core/aabb.h"

namespace twinray::embree {

/// How far from the coordinate origin a ray may start, in units of the scene's largest coordinate, so that
/// padded_for_embree() loses none of its hits.
inline constexpr float reach = 7;

/// A box that Embree's box test hits wherever the canonical test accepts a hit inside.
///
/// With u = 2^-24, A the scene's size and O <= reach A the origin's largest coordinate: the canonical test
/// sees the shape moved by up to 6 u (A + O); Embree sees a plane up to 7 u (A + O) beside its place (4 u by
/// the approximate reciprocal, 1 u each by the difference, the product and the origin's product). The box
/// grows by 16 u (A + reach A), and by more than what Embree takes as 0, numbers below 2^-126.
inline Aabb padded_for_embree(const Aabb& box, float scene_size) {
  const float pad = std::max(scene_size * (1 + reach) * 0x1p-20f, 0x1p-100f);
  return {box.lower - Vec3{pad, pad, pad}, box.upper + Vec3{pad, pad, pad}};
}

/// By how much, relatively, tfar lies behind a hit and tnear before t_min: far above the 32 u (u = 2^-24) to
/// which Embree's and the canonical parameters of one plane differ.
inline constexpr float slack = 0x1p-14f;

/// What Embree is told instead of these ends of an interval.
inline float told_t_min(float t_min) { return t_min * (1 - slack); }
inline float told_t_max(float t_max) { return t_max * (1 + slack); }

}  // namespace twinray::embree

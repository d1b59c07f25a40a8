// SPDX-License-Identifier: Apache-2.0
// Private: the canonical box test.
//
// One function serves the boxes of shapes and of tree nodes. It is monotone, bit for bit: a box that contains
// another has a near that is smaller or equal and a far that is larger or equal, because every step (padding,
// subtraction, multiplication, minimum and maximum) is monotone in floating point. So a node culled by it
// cannot hold an accepted hit. The widening (slab_margin) makes it conservative against the rounding of
// triangle.h.
#pragma once
#include <algorithm>
#include <cmath>

#include "accel/canonical/checked_ray.h"
#include "core/aabb.h"

namespace twinray {

/// The parameters at which a ray enters and leaves a box; near > far where it misses.
struct SlabInterval {
  float near, far;
};

/// A box's share of the rounding bound, by which each plane of it is moved outward.
inline float padding_of(const Aabb& box) {
  return std::max(max_abs(box.lower), max_abs(box.upper)) * slab_margin;
}

/// A box that is not empty, widened by its share of the rounding bound.
inline Aabb padded_full(const Aabb& box) {
  const float pad = padding_of(box);
  return {box.lower - Vec3{pad, pad, pad}, box.upper + Vec3{pad, pad, pad}};
}

/// The same of any box; an empty one stays empty.
inline Aabb padded(const Aabb& box) { return box.is_empty() ? box : padded_full(box); }

/// The slab test of a box that padded() has widened.
inline SlabInterval intersect_slab(const CheckedRay& ray, const Aabb& box) {
  // Read by index: a branch on a direction's sign is mispredicted for every other bounce ray.
  const float planes[3][2] = {
      {box.lower.x, box.upper.x}, {box.lower.y, box.upper.y}, {box.lower.z, box.upper.z}};
  const auto near_at = [&](int axis) {
    return (planes[axis][ray.is_negative[axis]] - ray.near_origin[axis]) * ray.near_inverse[axis];
  };
  const auto far_at = [&](int axis) {
    return (planes[axis][!ray.is_negative[axis]] - ray.far_origin[axis]) * ray.far_inverse[axis];
  };
  return {std::max(near_at(0), std::max(near_at(1), near_at(2))),
          std::min(far_at(0), std::min(far_at(1), far_at(2)))};
}

/// Gives a shape's hit at `t` its canonical parameter: not outside of [near, far] of the shape's own box, so
/// that no tree can cull the box and keep the hit, and so that a ray from t_min = t, or up to t_max = t,
/// still hits it. False where the box is missed or t lies outside of the closed interval [t_min, t_max].
inline bool clamp_to_box(const CheckedRay& ray, const Aabb& bounds, float t_max, float& t) {
  const SlabInterval interval = intersect_slab(ray, padded(bounds));
  if (interval.near > interval.far) return false;
  t = std::min(std::max(t, interval.near), interval.far);
  return t >= ray.t_min && t <= t_max;
}

/// From this size on, the largest coordinate of a triangle's box, is_within_box() is true of every t that the
/// rest of the triangle's test accepts, and need not be asked: the derivation of slab_margin counts relative
/// errors, and what underflow adds to them, at most 2^-126 / min_direction = 2^-86 along the ray, is then
/// below one u of it (u = 2^-24), which the rounding that it counts leaves free.
inline constexpr float min_proved_size = 0x1p-56f;

/// Whether a triangle's hit at `t` lies within [near, far] of its own box, so that no tree can cull the box
/// and keep the hit. By the derivation of slab_margin it always does; this makes it so by construction.
inline bool is_within_box(const CheckedRay& ray, const Aabb& bounds, float t) {
  const SlabInterval interval = intersect_slab(ray, padded_full(bounds));
  return (interval.near <= t) & (t <= interval.far);
}

}  // namespace twinray

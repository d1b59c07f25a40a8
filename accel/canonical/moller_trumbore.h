// SPDX-License-Identifier: Apache-2.0
// Private: the ray-triangle test of Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection",
// Journal of Graphics Tools 2(1), 1997.
//
// For comparison only: it is not watertight, and its hits are not the canonical ones of triangle.h. As in
// sphere.h, the hit's parameter is clamped to the triangle's own box, so that no tree loses what brute force
// finds by the same test.
#pragma once
#include "accel/canonical/triangle.h"

namespace twinray {

/// The hit of a ray with the triangle a, b, c in the closed interval [ray.t_min, t_max]; false for none.
inline bool intersect_moller_trumbore(const CheckedRay& ray, const Vec3& a, const Vec3& b, const Vec3& c,
                                      float t_max, ShapeHit& hit) {
  const Vec3 ab = b - a, ac = c - a, p = cross(ray.direction, ac), s = ray.origin - a;
  const float determinant = dot(ab, p);
  if (determinant == 0) return false;
  const float inverse = 1 / determinant;
  const Vec3 q = cross(s, ab);
  hit.u = dot(s, p) * inverse;
  hit.v = dot(ray.direction, q) * inverse;
  hit.t = dot(ac, q) * inverse;
  const bool is_inside = hit.u >= 0 && hit.v >= 0 && hit.u + hit.v <= 1;
  return is_inside && clamp_to_box(ray, triangle_bounds(a, b, c), t_max, hit.t);
}

}  // namespace twinray

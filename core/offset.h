// SPDX-License-Identifier: Apache-2.0
// Ray origins that leave a surface: the only such function, with a derived bound and no epsilon of the
// scene's size.
#pragma once
#include <algorithm>

#include "core/ray.h"
#include "core/surface.h"

namespace twinray {

/// Relative: ten times half a unit in the last place of a float.
inline constexpr float ten_roundings = 10 * 0x1p-24f;

/// How far from its computed position a ray must start, along the normal of a triangle, so that the canonical
/// test cannot find the triangle again: 10 u (M + E), with u = 2^-24, M the largest coordinate of the
/// triangle and E its largest edge. Interpolation is off by up to 4 u M in each component and the shift
/// itself by u M, 8.7 u M along the normal. The test sees each vertex within 6 u E in the two sheared
/// components and 3 u E in depth, 10 u E along the normal.
inline float triangle_offset(const Vec3& a, const Vec3& b, const Vec3& c) {
  const float coordinate = std::max(max_abs(a), std::max(max_abs(b), max_abs(c)));
  const float edge = std::max(max_abs(b - a), std::max(max_abs(c - a), max_abs(c - b)));
  return ten_roundings * (coordinate + edge);
}
/// The same for a sphere, 10 u (|centre| + radius): position and shift are off by up to 4 u of that in each
/// component, 7 u along the normal; the test works in double.
inline float sphere_offset(const Sphere& sphere) {
  return ten_roundings * (max_abs(sphere.center) + sphere.radius);
}

/// The point from which a ray along `direction` leaves the surface: moved to that side of it.
inline Vec3 leave_surface(const SurfacePoint& point, const Vec3& direction) {
  const float side = dot(point.geometric_normal, direction) < 0 ? -point.offset : point.offset;
  return point.position + point.geometric_normal * side;
}

/// The ray from a surface along a direction, to infinity.
inline Ray spawn_ray(const SurfacePoint& from, const Vec3& direction) {
  return {.origin = leave_surface(from, direction), .direction = direction};
}

/// The shadow ray between two points of surfaces: direction = target - origin, both moved off their surfaces
/// towards each other, and t_max = 1.
inline Ray connect(const SurfacePoint& from, const SurfacePoint& to) {
  const Vec3 towards = to.position - from.position;
  const Vec3 origin = leave_surface(from, towards);
  const Vec3 target = leave_surface(to, -towards);
  return {.origin = origin, .direction = target - origin, .t_max = 1};
}
/// The shadow ray from a surface to a point in space, such as a point light.
inline Ray connect(const SurfacePoint& from, const Vec3& to) {
  const Vec3 origin = leave_surface(from, to - from.position);
  return {.origin = origin, .direction = to - origin, .t_max = 1};
}

}  // namespace twinray

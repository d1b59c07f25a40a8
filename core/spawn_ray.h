// SPDX-License-Identifier: Apache-2.0
// Rays that leave a surface: the only such functions.
#pragma once
#include "core/offset.h"
#include "core/ray.h"
#include "core/surface.h"

namespace twinray {

/// The point from which a ray along `direction` leaves the surface: moved to that side of it.
inline Vec3 leave_surface(const Vec3& position, const Vec3& normal, float offset, const Vec3& direction) {
  const float side = dot(normal, direction) < 0 ? -offset : offset;
  return position + normal * side;
}
inline Vec3 leave_surface(const SurfacePoint& point, const Vec3& direction) {
  return leave_surface(point.position, point.geometric_normal, point.offset, direction);
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
  const Vec3 target =
      leave_surface(to.position, to.geometric_normal, to.offset + end_offset(towards), -towards);
  return {.origin = origin, .direction = target - origin, .t_max = 1};
}
/// The shadow ray from a surface to a point in space, such as a point light.
inline Ray connect(const SurfacePoint& from, const Vec3& to) {
  const Vec3 origin = leave_surface(from, to - from.position);
  return {.origin = origin, .direction = to - origin, .t_max = 1};
}

}  // namespace twinray

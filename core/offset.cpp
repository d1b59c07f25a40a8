// SPDX-License-Identifier: Apache-2.0
#include "core/offset.h"

#include <algorithm>
#include <cmath>

namespace twinray {
namespace {

constexpr float ten_roundings = 10 * 0x1p-24f;

}  // namespace

float triangle_offset(const Vec3& a, const Vec3& b, const Vec3& c) {
  const float coordinate = std::max(max_abs(a), std::max(max_abs(b), max_abs(c)));
  const float edge = std::max(max_abs(b - a), std::max(max_abs(c - a), max_abs(c - b)));
  return ten_roundings * (coordinate + edge);
}

float sphere_offset(const Sphere& sphere) { return ten_roundings * (max_abs(sphere.center) + sphere.radius); }

Vec3 leave_surface(const SurfacePoint& point, const Vec3& direction) {
  const float side = dot(point.geometric_normal, direction) < 0 ? -point.offset : point.offset;
  return point.position + point.geometric_normal * side;
}

Ray spawn_ray(const SurfacePoint& from, const Vec3& direction) {
  return {.origin = leave_surface(from, direction), .direction = direction};
}

Ray connect(const SurfacePoint& from, const SurfacePoint& to) {
  const Vec3 towards = to.position - from.position;
  const Vec3 origin = leave_surface(from, towards);
  const Vec3 target = leave_surface(to, -towards);
  return {.origin = origin, .direction = target - origin, .t_max = 1};
}

Ray connect(const SurfacePoint& from, const Vec3& to) {
  const Vec3 origin = leave_surface(from, to - from.position);
  return {.origin = origin, .direction = to - origin, .t_max = 1};
}

}  // namespace twinray

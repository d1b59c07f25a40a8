// SPDX-License-Identifier: Apache-2.0
// Of geometry.h what the canonical tests need: compiled for them alone, too, under several sets of flags.
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/area_vector.h"
#include "core/geometry.h"

namespace twinray {
namespace {

/// std::nextafter(x, infinity), which the C library makes a call of: each test of a sphere asks for six.
float next_up(float x) {
  if (!std::isfinite(x)) return x == -Aabb::infinity ? std::numeric_limits<float>::lowest() : x;
  if (x == 0) return std::numeric_limits<float>::denorm_min();
  const auto bits = std::bit_cast<std::uint32_t>(x);
  return std::bit_cast<float>(x > 0 ? bits + 1 : bits - 1);
}
float next_down(float x) { return -next_up(-x); }

}  // namespace

Aabb sphere_bounds(const Sphere& sphere) {
  Aabb box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lower[axis] = next_down(sphere.center[axis] - sphere.radius);
    box.upper[axis] = next_up(sphere.center[axis] + sphere.radius);
  }
  return box;
}

bool has_area(const Vec3& a, const Vec3& b, const Vec3& c) { return !AreaVector(a, b, c).is_zero(); }

}  // namespace twinray

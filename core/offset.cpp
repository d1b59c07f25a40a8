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

}  // namespace twinray

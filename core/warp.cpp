// SPDX-License-Identifier: Apache-2.0
#include "core/warp.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace twinray {
namespace {

/// A point at a signed distance r from the centre, at an eighth of a turn times `slope` in [-1, 1].
Vec2 wedge_point(float r, float slope) {
  const SinCos angle = sincos_turns(0.125f * std::fabs(slope));
  return {r * angle.cos, r * std::copysign(angle.sin, slope)};
}

/// The unit direction with 1 - z = one_minus_z in [0, 2], `turns` around z.
Vec3 direction_around_z(float one_minus_z, float turns) {
  const float r = std::sqrt(one_minus_z * (2 - one_minus_z));
  const SinCos angle = sincos_turns(turns);
  return {r * angle.cos, r * angle.sin, 1 - one_minus_z};
}

}  // namespace

Vec2 square_to_disc(Vec2 u) {
  const float x = 2 * u.x - 1, y = 2 * u.y - 1;
  if (x == 0 && y == 0) return {0, 0};
  if (std::fabs(x) > std::fabs(y)) return wedge_point(x, y / x);
  const Vec2 mirrored = wedge_point(y, x / y);
  return {mirrored.y, mirrored.x};
}

Vec2 square_to_polygon(Vec2 u, int corners, float turns) {
  const float place = u.x * float(corners);
  const int blade = std::min(int(place), corners - 1);
  const auto corner = [&](int i) {
    const float angle = turns + float(i) / float(corners);
    return sincos_turns(angle - std::floor(angle));
  };
  const SinCos from = corner(blade), to = corner(blade + 1);
  // The area within a distance grows as its square does.
  const float outward = std::sqrt(u.y), along = place - float(blade);
  return {outward * (from.cos + along * (to.cos - from.cos)),
          outward * (from.sin + along * (to.sin - from.sin))};
}

Vec3 square_to_cosine_hemisphere(Vec2 u) {
  const Vec2 disc = square_to_disc(u);
  // The distance from the centre, without the rounding of the point.
  const float r = std::max(std::fabs(2 * u.x - 1), std::fabs(2 * u.y - 1));
  return {disc.x, disc.y, std::sqrt((1 - r) * (1 + r))};
}

float cosine_hemisphere_pdf(float cos_theta) { return std::max(0.0f, cos_theta) / pi; }

Vec3 square_to_uniform_hemisphere(Vec2 u) { return direction_around_z(u.x, u.y); }

float uniform_hemisphere_pdf() { return 1 / (2 * pi); }

Vec3 square_to_uniform_sphere(Vec2 u) { return direction_around_z(2 * u.x, u.y); }

float uniform_sphere_pdf() { return 1 / (4 * pi); }

Vec3 square_to_uniform_cone(Vec2 u, float one_minus_cos) {
  return direction_around_z(u.x * one_minus_cos, u.y);
}

float uniform_cone_pdf(float one_minus_cos) { return 1 / (2 * pi * one_minus_cos); }

}  // namespace twinray

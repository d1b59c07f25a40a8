// SPDX-License-Identifier: Apache-2.0
// Maps of the unit square onto directions and points, each with its density. Input: u in [0, 1)^2.
#pragma once
#include <algorithm>

#include "core/angle.h"
#include "core/vec.h"

namespace twinray {

/// Uniform in the unit disc (Shirley and Chiu, "A Low Distortion Map Between Disk and Square", 1997). Density
/// per area: 1 / pi.
Vec2 square_to_disc(Vec2 u);

/// Uniform in the regular polygon whose corners, 3 or more, lie on the unit circle, the first of them at an
/// angle of `turns` in [0, 1) from +x: triangle after triangle around the middle. Density per area: 1 / area.
Vec2 square_to_polygon(Vec2 u, int corners, float turns);

/// Unit directions around +z with density cos(theta) / pi per solid angle (Malley's method). On the edge of
/// the square z, and the density, are 0.
Vec3 square_to_cosine_hemisphere(Vec2 u);
/// 0 below the horizon.
float cosine_hemisphere_pdf(float cos_theta);

/// Unit directions around +z with the constant density 1 / (2 pi) per solid angle.
Vec3 square_to_uniform_hemisphere(Vec2 u);
float uniform_hemisphere_pdf();

/// Unit directions with the constant density 1 / (4 pi) per solid angle.
Vec3 square_to_uniform_sphere(Vec2 u);
float uniform_sphere_pdf();

/// Unit directions within the cone around +z whose half-angle has one_minus_cos = 1 - cos in (0, 2]; constant
/// density per solid angle. The difference is passed, not the cosine, so that narrow cones keep their
/// precision.
Vec3 square_to_uniform_cone(Vec2 u, float one_minus_cos);
float uniform_cone_pdf(float one_minus_cos);

/// Weights (of the second and the third vertex) of points of a triangle, uniform by area (Heitz, "A
/// Low-Distortion Map Between Triangle and Square", 2019). Both >= 0, their sum at most 1.
inline Vec2 square_to_triangle(Vec2 u) {
  const float half = 0.5f * std::min(u.x, u.y);
  return {u.x - half, u.y - half};
}

}  // namespace twinray

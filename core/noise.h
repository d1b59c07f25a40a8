// SPDX-License-Identifier: Apache-2.0
// Patterns without a picture: smooth noise in space (Perlin, "Improving Noise", 2002), and what is made of
// it. The same numbers as pbrt-v4's, but for rounding.
#pragma once
#include "core/rgb.h"
#include "core/vec.h"

namespace twinray {

/// In [-1, 1], 0 at all whole points, repeating after 256 along each axis. 0 beyond 2^30 and where the point
/// is not finite.
float noise(const Vec3& p);

/// What patterns add up: noise, and the same again and again about twice as fine and less strong.
struct Octaves {
  int most = 8;            ///< Of them; >= 0.
  float roughness = 0.5f;  ///< How strong each is beside the one before it.
};

/// The sum of octaves; those finer than the width of what is seen are left out.
float fbm(const Vec3& p, float width, const Octaves& octaves);
/// The sum of the octaves' absolute values, with creases where one is 0; about their mean, 0.2, stands for
/// those left out.
float turbulence(const Vec3& p, float width, const Octaves& octaves);

/// Whether a point lies in one of the dots of radius 0.35 that some of the squares of side 1 have, anywhere
/// within; squares lie around whole points.
bool is_in_dot(Vec2 st);
/// The part of the plane that lies in dots: 25,832 of 256 x 256 squares have one.
inline constexpr float part_in_dots = 25832.0f / 65536 * 3.14159265f * 0.35f * 0.35f;

/// The colour of marble whose layers are at this phase, in radians.
Rgb marble_color(float phase);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// How far a ray must start from its surface: derived bounds, no epsilon of the scene's size.
#pragma once
#include <algorithm>

#include "core/vec.h"

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
inline float sphere_offset(const Vec3& center, float radius) {
  return ten_roundings * (max_abs(center) + radius);
}

/// The square of how far from a sphere's centre a point must be to lie outside for certain, and not on the
/// sphere itself but for rounding. `offset`: sphere_offset().
inline double squared_reach(float radius, float offset) {
  const double reach = double(radius) + offset;
  return reach * reach;
}

/// How much farther the end of a shadow ray must be moved off the surface that it goes to, `between` being
/// the way there: 12 u D, with D its largest component. The direction is rounded, which moves the end by u D
/// in each component, 1.8 u D along the normal; and the test sees each vertex, less than D + E away, within 6
/// u of that in the two sheared components and 3 u in depth, 10 u along the normal. What E adds
/// triangle_offset() has.
inline constexpr float twelve_roundings = 12 * 0x1p-24f;
inline float end_offset(const Vec3& between) { return twelve_roundings * max_abs(between); }

}  // namespace twinray

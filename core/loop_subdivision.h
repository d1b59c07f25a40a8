// SPDX-License-Identifier: Apache-2.0
// Loop's subdivision surfaces (C. Loop, "Smooth Subdivision Surfaces Based on Triangles", 1987), with the
// weights of J. Warren for vertices that have other than six neighbours.
//
// OpenSubdiv would do, but its weights are made of the C library's cosines, whose last bits differ from one
// machine to another (docs/determinism.md).
#pragma once
#include <cstddef>
#include <optional>

#include "core/geometry.h"

namespace twinray {

/// Levels that may be asked for: each has four times as many triangles.
inline constexpr int most_loop_levels = 12;

/// How many triangles a mesh of so many has then.
constexpr double loop_triangles(std::size_t triangles, int levels) {
  double count = double(triangles);
  for (int level = 0; level < levels; ++level) count *= 4;
  return count;
}

/// A control mesh, divided so many times; its vertices then lie on the limit surface, and have that surface's
/// normals, which look to the side from which triangles run counter-clockwise. The limit does not depend on
/// the levels. Edges of one triangle end the surface in a smooth curve (a cubic B-spline). Only positions and
/// triangles of the control mesh count. None where it is no surface: more than two triangles at an edge, or
/// two that run along it the same way; a triangle with one vertex twice; or triangles at a vertex that hang
/// together there alone. `levels` in [0, most_loop_levels]; fewer than 2^31 triangles come of it.
std::optional<Mesh> loop_subdivided(const Mesh& control, int levels);

}  // namespace twinray

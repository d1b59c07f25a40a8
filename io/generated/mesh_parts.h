// SPDX-License-Identifier: Apache-2.0
// Pieces that are appended to a mesh.
#pragma once
#include <functional>

#include "core/aabb.h"
#include "core/geometry.h"
#include "core/transform.h"

namespace twinray::generated {

/// A point of a surface for (u, v) in [0, 1]^2.
using SurfaceFunction = std::function<Vec3(float u, float v)>;
/// How far a point of a ball lies from its centre, for a unit direction.
using RadiusFunction = std::function<float(const Vec3& direction)>;

void add_triangle(Mesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c);
/// Two triangles; the corners in winding order.
void add_quad(Mesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
/// Twelve triangles, fronts outward.
void add_box(Mesh& mesh, const Aabb& box);
/// The same, placed by a transform that does not mirror.
void add_box(Mesh& mesh, const Aabb& box, const Transform& place);
/// 2 columns rows triangles.
void add_surface(Mesh& mesh, int columns, int rows, const SurfaceFunction& point);

/// The side of a cone's frustum along a line.
struct Tube {
  Vec3 from, to;  ///< Apart from each other.
  float radius_from = 0.02f, radius_to = 0.02f;
  int sides = 8, rings = 1;
};
/// 2 sides rings triangles, without caps.
void add_tube(Mesh& mesh, const Tube& tube);

/// A cube's six faces of n x n squares, blown up to a ball: 12 n^2 triangles, fronts outward.
void add_ball(Mesh& mesh, const Vec3& center, int n, const RadiusFunction& radius);
void add_ball(Mesh& mesh, const Vec3& center, int n, float radius);

}  // namespace twinray::generated

// SPDX-License-Identifier: Apache-2.0
#include "io/encloses.h"

#include <algorithm>

#include "io/axis.h"
#include "io/placed_mesh.h"

namespace twinray {
namespace {

/// Whether the ray crosses a triangle (Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle
/// Intersection", 1997).
bool crosses(const Axis& origin, const Vec3& a, const Vec3& b, const Vec3& c) {
  constexpr Axis direction{0.283, 0.867, 0.41};  // Seldom in a plane of a mesh, or through an edge.
  const Axis ab = Axis::of(b) - Axis::of(a), ac = Axis::of(c) - Axis::of(a), from_a = origin - Axis::of(a);
  const Axis p = direction.cross(ac), q = from_a.cross(ab);
  const double determinant = ab.dot(p);
  if (determinant == 0) return false;
  const double u = from_a.dot(p) / determinant, v = direction.dot(q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && ac.dot(q) / determinant > 0;
}

}  // namespace

bool encloses(const Shape& shape, const Vec3& point) {
  if (!bounds_of(shape).contains(Aabb{point, point})) return false;
  if (const auto* const set = std::get_if<SphereSet>(&shape))
    return std::any_of(set->spheres.begin(), set->spheres.end(), [&](const Sphere& sphere) {
      return (Axis::of(point) - Axis::of(sphere.center)).length() < double(sphere.radius);
    });
  const Mesh& mesh = std::get<Mesh>(shape);
  const auto crossings =
      std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& triangle) {
        const auto& [a, b, c] = triangle;
        return crosses(Axis::of(point), mesh.positions[a], mesh.positions[b], mesh.positions[c]);
      });
  return crossings % 2 == 1;
}

}  // namespace twinray

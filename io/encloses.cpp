// SPDX-License-Identifier: Apache-2.0
#include "io/encloses.h"

#include <algorithm>
#include <array>

#include "io/placed_mesh.h"

namespace twinray {
namespace {

using Wide3 = std::array<double, 3>;

Wide3 wide_difference(const Vec3& a, const Vec3& b) {
  return {double(a.x) - double(b.x), double(a.y) - double(b.y), double(a.z) - double(b.z)};
}
Wide3 wide_cross(const Wide3& a, const Wide3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double wide_dot(const Wide3& a, const Wide3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Whether the ray crosses a triangle (Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle
/// Intersection", 1997).
bool crosses(const Vec3& origin, const Vec3& a, const Vec3& b, const Vec3& c) {
  constexpr Wide3 direction{0.283, 0.867, 0.41};  // Seldom in a plane of a mesh, or through an edge.
  const Wide3 ab = wide_difference(b, a), ac = wide_difference(c, a), from_a = wide_difference(origin, a);
  const Wide3 p = wide_cross(direction, ac), q = wide_cross(from_a, ab);
  const double determinant = wide_dot(ab, p);
  if (determinant == 0) return false;
  const double u = wide_dot(from_a, p) / determinant, v = wide_dot(direction, q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && wide_dot(ac, q) / determinant > 0;
}

}  // namespace

bool encloses(const Shape& shape, const Vec3& point) {
  if (!bounds_of(shape).contains(Aabb{point, point})) return false;
  if (const auto* const set = std::get_if<SphereSet>(&shape))
    return std::any_of(set->spheres.begin(), set->spheres.end(), [&](const Sphere& sphere) {
      const Wide3 way = wide_difference(point, sphere.center);
      return wide_dot(way, way) < double(sphere.radius) * double(sphere.radius);
    });
  const Mesh& mesh = std::get<Mesh>(shape);
  const auto crossings =
      std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& triangle) {
        const auto& [a, b, c] = triangle;
        return crosses(point, mesh.positions[a], mesh.positions[b], mesh.positions[c]);
      });
  return crossings % 2 == 1;
}

}  // namespace twinray

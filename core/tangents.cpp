// SPDX-License-Identifier: Apache-2.0
#include "core/tangents.h"

#include <cmath>

namespace twinray {
namespace {

std::optional<Tangents> usable(const Tangents& tangents) {
  const float squared = length_squared(cross(tangents.du, tangents.dv));
  if (!(squared > 0) || !std::isfinite(squared)) return std::nullopt;
  return tangents;
}

/// Solves a - c = (u_a - u_c) dp/du + (v_a - v_c) dp/dv for two edges.
std::optional<Tangents> of_triangle(const Mesh& mesh, std::uint32_t triangle) {
  const auto& [ia, ib, ic] = mesh.triangles[triangle];
  const auto& [ta, tb, tc] = mesh.uv_indices[triangle];
  const Vec3 p = mesh.positions[ib] - mesh.positions[ia], q = mesh.positions[ic] - mesh.positions[ia];
  const Vec2 &a = mesh.uvs[ta], &b = mesh.uvs[tb], &c = mesh.uvs[tc];
  const double pu = double(b.x) - double(a.x), pv = double(b.y) - double(a.y);
  const double qu = double(c.x) - double(a.x), qv = double(c.y) - double(a.y);
  const double determinant = pu * qv - pv * qu;
  if (determinant == 0) return std::nullopt;
  const auto solve = [&](double of_p, double of_q) {
    return p * float(of_p / determinant) + q * float(of_q / determinant);
  };
  return usable({solve(qv, -pv), solve(-qu, pu)});
}

/// The derivatives of core/octahedron.h: of the octahedron's point by u and v, and of its projection to the
/// sphere.
std::optional<Tangents> of_sphere(const Sphere& sphere, const Vec3& normal) {
  const float x = std::copysign(1.0f, normal.x), y = std::copysign(1.0f, normal.y);
  const bool is_folded = normal.z < 0;
  const Vec3 du = is_folded ? Vec3{0, -x * y, -x} : Vec3{1, 0, -x};
  const Vec3 dv = is_folded ? Vec3{-x * y, 0, -y} : Vec3{0, 1, -y};
  const float scale = 2 * sphere.radius * (std::fabs(normal.x) + std::fabs(normal.y) + std::fabs(normal.z));
  const auto project = [&](const Vec3& d) { return (d - normal * dot(d, normal)) * scale; };
  return usable({project(du), project(dv)});
}

/// In the space of the point's shape, whose unit normal there is `normal`.
std::optional<Tangents> own_tangents(const Geometry& geometry, const SurfacePoint& point,
                                     const Vec3& normal) {
  if (const SphereSet* set = geometry.sphere_set(point.shape))
    return of_sphere(set->spheres[point.primitive], normal);
  const Mesh& mesh = *geometry.mesh(point.shape);
  if (mesh.uvs.empty()) return std::nullopt;
  return of_triangle(mesh, point.primitive);
}

}  // namespace

std::optional<Tangents> tangents_at(const Geometry& geometry, const SurfacePoint& point) {
  const Transform* const to_world = geometry.to_world(point.instance);
  if (!to_world) return own_tangents(geometry, point, point.geometric_normal);
  const Vec3 normal = normalize(to_world->transposed_vector(point.geometric_normal));
  const std::optional<Tangents> own = own_tangents(geometry, point, normal);
  if (!own) return std::nullopt;
  return usable({to_world->vector(own->du), to_world->vector(own->dv)});
}

}  // namespace twinray

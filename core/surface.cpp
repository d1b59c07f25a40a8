// SPDX-License-Identifier: Apache-2.0
#include "core/surface.h"

#include <algorithm>
#include <cmath>

#include "core/octahedron.h"
#include "core/offset.h"

namespace twinray {
namespace {

/// The unit normal of a triangle with area; in double, because a small triangle's cross product underflows in
/// float.
Vec3 face_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double ux = double(b.x) - a.x, uy = double(b.y) - a.y, uz = double(b.z) - a.z;
  const double vx = double(c.x) - a.x, vy = double(c.y) - a.y, vz = double(c.z) - a.z;
  const double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
  const double length = std::sqrt(x * x + y * y + z * z);
  return {float(x / length), float(y / length), float(z / length)};
}

/// Interpolates, and stays within the box of the corners: a point of a wall never lies behind the wall beside
/// it because of rounding.
Vec3 interpolate(const Vec3& a, const Vec3& b, const Vec3& c, float u, float v) {
  const float w = 1 - u - v;
  Vec3 p = a * w + b * u + c * v;
  for (int axis = 0; axis < 3; ++axis)
    p[axis] = std::clamp(p[axis], std::min(a[axis], std::min(b[axis], c[axis])),
                         std::max(a[axis], std::max(b[axis], c[axis])));
  return p;
}

Vec3 shading_normal(const Mesh& mesh, std::uint32_t triangle, float u, float v, const Vec3& geometric) {
  if (mesh.normals.empty()) return geometric;
  const auto [a, b, c] = mesh.normal_indices[triangle];
  const Vec3 n = mesh.normals[a] * (1 - u - v) + mesh.normals[b] * u + mesh.normals[c] * v;
  const float squared = length_squared(n);
  if (!(squared > 1e-12f) || !std::isfinite(squared)) return geometric;
  const Vec3 unit = n / std::sqrt(squared);
  return dot(unit, geometric) < 0 ? -unit : unit;
}

Vec2 texture_coordinates(const Mesh& mesh, std::uint32_t triangle, float u, float v) {
  if (mesh.uvs.empty()) return {u, v};
  const auto [a, b, c] = mesh.uv_indices[triangle];
  return mesh.uvs[a] * (1 - u - v) + mesh.uvs[b] * u + mesh.uvs[c] * v;
}

}  // namespace

SurfacePoint triangle_point(const Geometry& geometry, std::uint32_t shape, std::uint32_t triangle, float u,
                            float v) {
  const Mesh& mesh = *geometry.mesh(shape);
  const auto [ia, ib, ic] = mesh.triangles[triangle];
  const Vec3 &a = mesh.positions[ia], &b = mesh.positions[ib], &c = mesh.positions[ic];
  SurfacePoint point;
  point.position = interpolate(a, b, c, u, v);
  point.geometric_normal = face_normal(a, b, c);
  point.shading_normal = shading_normal(mesh, triangle, u, v, point.geometric_normal);
  point.uv = texture_coordinates(mesh, triangle, u, v);
  point.offset = triangle_offset(a, b, c);
  point.shape = shape;
  return point;
}

SurfacePoint sphere_point(const Sphere& sphere, std::uint32_t shape, const Vec3& normal) {
  SurfacePoint point;
  point.position = sphere.center + normal * sphere.radius;
  point.geometric_normal = normal;
  point.shading_normal = normal;
  point.offset = sphere_offset(sphere);
  point.shape = shape;
  return point;
}

SurfacePoint surface_at(const Geometry& geometry, const Hit& hit) {
  if (geometry.mesh(hit.mesh)) return triangle_point(geometry, hit.mesh, hit.primitive, hit.u, hit.v);
  const Sphere& sphere = geometry.sphere_set(hit.mesh)->spheres[hit.primitive];
  SurfacePoint point = sphere_point(sphere, hit.mesh, octahedral_decode(hit.u, hit.v));
  point.uv = {hit.u, hit.v};
  return point;
}

}  // namespace twinray

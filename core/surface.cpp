// SPDX-License-Identifier: Apache-2.0
#include "core/surface.h"

#include <algorithm>
#include <cmath>

#include "core/lanes.h"
#include "core/octahedron.h"
#include "core/offset.h"
#include "core/triangle_weights.h"

namespace twinray {
namespace {

Float4 lanes_of(const Vec3& v) { return Float4{v.x, v.y, v.z, 0}; }

/// Interpolates, and stays within the box of the corners: a point of a wall never lies behind the wall beside
/// it because of rounding.
Vec3 interpolate(const Vec3& corner_a, const Vec3& corner_b, const Vec3& corner_c,
                 const TriangleWeights& weights) {
  const Float4 a = lanes_of(corner_a), b = lanes_of(corner_b), c = lanes_of(corner_c);
  const Float4 p = a * weights.a + b * weights.b + c * weights.c;
  const Float4 low = min(min(c, b), a), high = max(max(c, b), a);
  const Float4 inside = min(high, max(low, p));
  return {inside[0], inside[1], inside[2]};
}

Vec3 mixed_normal(const Mesh& mesh, std::uint32_t triangle, float u, float v) {
  const auto& [a, b, c] = mesh.normal_indices[triangle];
  return mesh.normals[a] * (1 - u - v) + mesh.normals[b] * u + mesh.normals[c] * v;
}

Vec3 shading_normal(const Mesh& mesh, std::uint32_t triangle, float u, float v, const Vec3& geometric) {
  if (mesh.normals.empty()) return geometric;
  const Vec3 n = mixed_normal(mesh, triangle, u, v);
  const float squared = length_squared(n);
  if (!(squared > 1e-12f) || !std::isfinite(squared)) return geometric;
  return n / std::sqrt(squared);
}

Vec2 texture_coordinates(const Mesh& mesh, std::uint32_t triangle, float u, float v) {
  if (mesh.uvs.empty()) return {u, v};
  const auto& [a, b, c] = mesh.uv_indices[triangle];
  return mesh.uvs[a] * (1 - u - v) + mesh.uvs[b] * u + mesh.uvs[c] * v;
}

}  // namespace

SurfacePoint triangle_point(const Geometry& geometry, std::uint32_t shape, std::uint32_t triangle, float u,
                            float v) {
  const Mesh& mesh = *geometry.mesh(shape);
  const auto& [ia, ib, ic] = mesh.triangles[triangle];
  const Vec3 &a = mesh.positions[ia], &b = mesh.positions[ib], &c = mesh.positions[ic];
  const Facet& facet = geometry.facet(shape, triangle);
  SurfacePoint point;
  point.offset = facet.offset;
  point.position = interpolate(a, b, c, keep_off_edges(a, b, c, {1 - u - v, u, v}, facet.offset));
  point.geometric_normal = point.shading_normal = facet.normal;
  point.uv = {u, v};
  point.shape = shape;
  point.primitive = triangle;
  return point;
}

SurfacePoint sphere_point(const Sphere& sphere, std::uint32_t shape, const Vec3& normal) {
  SurfacePoint point;
  point.position = sphere.center + normal * sphere.radius;
  point.geometric_normal = normal;
  point.shading_normal = normal;
  point.offset = sphere_offset(sphere.center, sphere.radius);
  point.shape = shape;
  return point;
}

namespace {

// Each kind of point is one variable of a function of its own, so that it is made where it goes.

SurfacePoint mesh_point(const Geometry& geometry, const Mesh& mesh, const Hit& hit) {
  SurfacePoint point = triangle_point(geometry, hit.mesh, hit.primitive, hit.u, hit.v);
  point.shading_normal = shading_normal(mesh, hit.primitive, hit.u, hit.v, point.geometric_normal);
  point.uv = texture_coordinates(mesh, hit.primitive, hit.u, hit.v);
  return point;
}

SurfacePoint sphere_hit_point(const Sphere& sphere, const Hit& hit) {
  SurfacePoint point = sphere_point(sphere, hit.mesh, octahedral_decode(hit.u, hit.v));
  point.uv = {hit.u, hit.v};
  point.primitive = hit.primitive;
  return point;
}

}  // namespace

SurfacePoint surface_at(const Geometry& geometry, const Hit& hit) {
  if (const Mesh* mesh = geometry.mesh(hit.mesh)) return mesh_point(geometry, *mesh, hit);
  return sphere_hit_point(geometry.sphere_set(hit.mesh)->spheres[hit.primitive], hit);
}

Vec2 texture_coordinates(const Geometry& geometry, const Hit& hit) {
  const Mesh* mesh = geometry.mesh(hit.mesh);
  return mesh ? texture_coordinates(*mesh, hit.primitive, hit.u, hit.v) : Vec2{hit.u, hit.v};
}

Vec3 mixed_normal(const Geometry& geometry, const Hit& hit) {
  const Mesh* mesh = geometry.mesh(hit.mesh);
  if (!mesh) return octahedral_decode(hit.u, hit.v);
  if (mesh->normals.empty()) return geometry.facet(hit.mesh, hit.primitive).normal;
  return mixed_normal(*mesh, hit.primitive, hit.u, hit.v);
}

}  // namespace twinray

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

/// Of the normals of a triangle's corners, each of which an instance takes along by itself.
Vec3 mixed_normal(const Mesh& mesh, const Hit& hit, const Transform* to_world) {
  const auto normal = [&](std::uint32_t index) {
    return to_world ? to_world->front(mesh.normals[index]) : mesh.normals[index];
  };
  const auto& [a, b, c] = mesh.normal_indices[hit.primitive];
  return normal(a) * (1 - hit.u - hit.v) + normal(b) * hit.u + normal(c) * hit.v;
}

Vec3 shading_normal(const Mesh& mesh, const Hit& hit, const Transform* to_world, const Vec3& geometric) {
  const Vec3 n = mixed_normal(mesh, hit, to_world);
  const float squared = length_squared(n);
  if (!(squared > 1e-12f) || !std::isfinite(squared)) return geometric;
  return n / std::sqrt(squared);
}

Vec2 texture_coordinates(const Mesh& mesh, std::uint32_t triangle, float u, float v, CoordinateSet set) {
  const auto& [uvs, indices] = uv_set(mesh, set);
  if (uvs.empty()) return {u, v};
  const auto& [a, b, c] = indices[triangle];
  return uvs[a] * (1 - u - v) + uvs[b] * u + uvs[c] * v;
}

}  // namespace

SurfacePoint triangle_point(const Geometry& geometry, std::uint32_t shape, std::uint32_t triangle, float u,
                            float v) {
  const Mesh& mesh = *geometry.mesh(shape);
  const auto& [ia, ib, ic] = mesh.triangles[triangle];
  const Vec3 &a = mesh.positions[ia], &b = mesh.positions[ib], &c = mesh.positions[ic];
  const Facet facet(a, b, c);
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
  const auto uv = [&](CoordinateSet set) {
    return texture_coordinates(mesh, hit.primitive, hit.u, hit.v, set);
  };
  point.uv = uv(CoordinateSet::first);
  point.second_uv = mesh.second_uvs.empty() ? point.uv : uv(CoordinateSet::second);
  return point;
}

SurfacePoint sphere_hit_point(const Sphere& sphere, const Hit& hit) {
  SurfacePoint point = sphere_point(sphere, hit.mesh, octahedral_decode(hit.u, hit.v));
  point.uv = point.second_uv = {hit.u, hit.v};
  point.primitive = hit.primitive;
  return point;
}

/// In the space of the hit's shape, without the normals of a mesh's corners.
SurfacePoint own_point(const Geometry& geometry, const Hit& hit) {
  if (const Mesh* mesh = geometry.mesh(hit.mesh)) return mesh_point(geometry, *mesh, hit);
  return sphere_hit_point(geometry.sphere_set(hit.mesh)->spheres[hit.primitive], hit);
}

/// Moves a point of a prototype into the scene. For a unit normal n of the scene, a way d along it is one of
/// d / |A^T n| along the prototype's normal. The prototype's offset allows for what is rounded there; the
/// position and the shifted origin are rounded once more, by 2 u of their size each along the normal.
void move_to_world(const Transform& to_world, SurfacePoint& point) {
  point.position = to_world.point(point.position);
  point.geometric_normal = point.shading_normal = to_world.front(point.geometric_normal);
  const float stretch = length(to_world.transposed_vector(point.geometric_normal));
  point.offset = stretch * point.offset + 0.5f * ten_roundings * max_abs(point.position);
}

}  // namespace

SurfacePoint surface_at(const Geometry& geometry, const Hit& hit) {
  SurfacePoint point = own_point(geometry, hit);
  const Transform* const to_world = geometry.to_world(hit.instance);
  if (to_world) {
    point.instance = hit.instance;
    move_to_world(*to_world, point);
  }
  if (const Mesh* mesh = geometry.mesh(hit.mesh); mesh && !mesh->normals.empty())
    point.shading_normal = shading_normal(*mesh, hit, to_world, point.geometric_normal);
  return point;
}

Vec2 texture_coordinates(const Geometry& geometry, const Hit& hit, CoordinateSet set) {
  const Mesh* mesh = geometry.mesh(hit.mesh);
  return mesh ? texture_coordinates(*mesh, hit.primitive, hit.u, hit.v, set) : Vec2{hit.u, hit.v};
}

Vec3 mixed_normal(const Geometry& geometry, const Hit& hit) {
  const Mesh* mesh = geometry.mesh(hit.mesh);
  const Transform* const to_world = geometry.to_world(hit.instance);
  if (mesh && !mesh->normals.empty()) return mixed_normal(*mesh, hit, to_world);
  const Vec3 normal = mesh ? geometry.facet(hit.mesh, hit.primitive).normal : octahedral_decode(hit.u, hit.v);
  return to_world ? to_world->front(normal) : normal;
}

}  // namespace twinray

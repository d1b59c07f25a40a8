// SPDX-License-Identifier: Apache-2.0
#include "io/placed_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/box_corners.h"
#include "core/mesh_area.h"

namespace twinray {

void move_positions(Mesh& mesh, const Transform& to_world, const FailPlacing& fail) {
  for (Vec3& p : mesh.positions) {
    p = to_world.point(p);
    if (is_finite(p) && max_abs(p) > max_coordinate)
      fail(fmt::format("a vertex of \"{}\" comes to ({}, {}, {}); coordinates must lie within +-{:g}",
                       mesh.name, p.x, p.y, p.z, max_coordinate));
  }
}

namespace {

void turn_winding(Mesh& mesh) {
  for (auto* indices : {&mesh.triangles, &mesh.normal_indices, &mesh.uv_indices, &mesh.second_uv_indices})
    for (Triangle& triangle : *indices) std::swap(triangle[1], triangle[2]);
}

void drop_unused_vertices(Mesh& mesh) {
  constexpr std::uint32_t unused = 0xffffffff;
  std::vector<std::uint32_t> moved(mesh.positions.size(), unused);
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t i : triangle) moved[i] = 0;
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    if (moved[i] == unused) continue;
    moved[i] = count;
    mesh.positions[count++] = mesh.positions[i];
  }
  mesh.positions.resize(count);
  for (Triangle& triangle : mesh.triangles)
    for (std::uint32_t& i : triangle) i = moved[i];
}

std::size_t fill_zero_normals(Mesh& mesh) {
  std::size_t filled = 0;
  for (std::size_t t = 0; t < mesh.normal_indices.size(); ++t)
    for (std::uint32_t& i : mesh.normal_indices[t]) {
      if (max_abs(mesh.normals[i]) > 0) continue;
      mesh.normals.push_back(area_vector(mesh, mesh.triangles[t]).normal());
      i = std::uint32_t(mesh.normals.size() - 1);
      ++filled;
    }
  return filled;
}

}  // namespace

Aabb bounds_of(const Shape& shape) {
  Aabb box;
  if (const auto* set = std::get_if<SphereSet>(&shape))
    for (const Sphere& sphere : set->spheres) box.extend(sphere_bounds(sphere));
  if (const auto* mesh = std::get_if<Mesh>(&shape))
    for (const Vec3& position : mesh->positions) box.extend(position);
  return box;
}

void check_reach(const Aabb& box, const Transform& to_world, const FailPlacing& fail) {
  if (box.is_empty()) return;
  for (const Vec3& corner : corners_of(box))
    if (const Vec3 p = to_world.point(corner); !(max_abs(p) <= max_coordinate))
      fail(fmt::format("this instance reaches to ({:g}, {:g}, {:g}); coordinates must lie within +-{:g}", p.x,
                       p.y, p.z, max_coordinate));
}

void turn_normals(Mesh& mesh, const Transform& to_world) {
  for (Vec3& n : mesh.normals) n = to_world.front(n);
}

void clean_up(PlacedMesh& placed) {
  placed.dropped = drop_degenerate_triangles(placed.mesh);
  drop_unused_vertices(placed.mesh);
  placed.without_normals = fill_zero_normals(placed.mesh);
}

PlacedMesh place_mesh(const Mesh& local, const Transform& to_world, const FailPlacing& fail) {
  PlacedMesh placed{local};
  Mesh& mesh = placed.mesh;
  drop_unused_vertices(mesh);
  move_positions(mesh, to_world, fail);
  turn_normals(mesh, to_world);
  if (to_world.determinant() < 0) turn_winding(mesh);
  clean_up(placed);
  return placed;
}

}  // namespace twinray

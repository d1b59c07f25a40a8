// SPDX-License-Identifier: Apache-2.0
#include "io/placed_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

/// The transform with its linear part scaled to about 1, so that its cofactors neither overflow nor vanish.
Transform of_unit_size(const Transform& t) {
  double largest = 0;
  for (const auto& row : t.m)
    for (int c = 0; c < 3; ++c) largest = std::max(largest, std::fabs(row[c]));
  Transform result = t;
  if (largest > 0)
    for (auto& row : result.m)
      for (int c = 0; c < 3; ++c) row[c] /= largest;
  return result;
}

/// The unit vector, or 0 0 0 where there is none.
Vec3 unit_or_zero(const Vec3& n) {
  const double x = n.x, y = n.y, z = n.z, length = std::sqrt(x * x + y * y + z * z);
  if (!(length > 0) || !std::isfinite(length)) return {0, 0, 0};
  return {float(x / length), float(y / length), float(z / length)};
}

void transform_normals(Mesh& mesh, const Transform& to_world) {
  const Transform unit_size = of_unit_size(to_world);
  // A mirroring transform's cofactors flip the normals; the winding is flipped back, and so are they.
  const float sign = to_world.determinant() < 0 ? -1.0f : 1.0f;
  for (Vec3& n : mesh.normals) n = unit_or_zero(unit_size.normal(unit_or_zero(n)) * sign);
}

void turn_winding(Mesh& mesh) {
  for (auto* indices : {&mesh.triangles, &mesh.normal_indices, &mesh.uv_indices})
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

void normalize_normals(Mesh& mesh) {
  for (Vec3& n : mesh.normals) n = unit_or_zero(n);
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
  transform_normals(mesh, to_world);
  if (to_world.determinant() < 0) turn_winding(mesh);
  clean_up(placed);
  return placed;
}

}  // namespace twinray

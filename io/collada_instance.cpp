// SPDX-License-Identifier: Apache-2.0
#include "io/collada_instance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/mesh_area.h"
#include "io/cs184_normals.h"

namespace twinray {
namespace {

/// A part of the vertices may not be finite; those are dropped with their triangles.
void transform_positions(Mesh& mesh, const Transform& to_world, const XmlElement& instance) {
  for (Vec3& p : mesh.positions) {
    p = to_world.point(p);
    if (is_finite(p) && max_abs(p) > max_coordinate)
      instance.fail(
          fmt::format("a vertex of \"{}\" comes to ({}, {}, {}); coordinates must lie within +-{:g}",
                      mesh.name, p.x, p.y, p.z, max_coordinate));
  }
}

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

PlacedMesh place_mesh(const Mesh& local, const Transform& to_world, const XmlElement& instance) {
  PlacedMesh placed{local};
  Mesh& mesh = placed.mesh;
  drop_unused_vertices(mesh);
  transform_positions(mesh, to_world, instance);
  transform_normals(mesh, to_world);
  if (to_world.determinant() < 0) turn_winding(mesh);
  placed.dropped = drop_degenerate_triangles(mesh);
  drop_unused_vertices(mesh);
  placed.without_normals = fill_zero_normals(mesh);
  return placed;
}

namespace {

FaceList faces_of(const ColladaPart& part) {
  FaceList faces;
  auto reduced = part.reduced.begin();
  for (std::size_t i = 0; i < part.mesh.triangles.size(); ++i)
    if (reduced != part.reduced.end() && reduced->triangle == i)
      faces.add((reduced++)->corners);
    else
      faces.add(part.mesh.triangles[i]);
  return faces;
}

std::vector<DoublePoint> transformed(const std::vector<Vec3>& positions, const Transform& t) {
  std::vector<DoublePoint> points;
  points.reserve(positions.size());
  for (const Vec3& p : positions) {
    DoublePoint& point = points.emplace_back();
    for (std::size_t row = 0; row < 3; ++row)
      point[row] = t.m[row][0] * p.x + t.m[row][1] * p.y + t.m[row][2] * p.z + t.m[row][3];
  }
  return points;
}

}  // namespace

PlacedMesh place_cs184_mesh(const ColladaPart& part, const Transform& to_world, const XmlElement& instance,
                            ColladaDocument& document, Aabb& bounds) {
  const FaceList faces = faces_of(part);
  VertexNormals smooth = cs184_normals(faces, transformed(part.mesh.positions, to_world));
  if (!smooth.fault.empty())
    document.warn(
        part.element,
        fmt::format("CS184's program refuses this mesh, since {}; it gets smooth normals without the "
                    "program's rule for borders",
                    smooth.fault));
  PlacedMesh placed{part.mesh};
  Mesh& mesh = placed.mesh;
  mesh.normals = std::move(smooth.normals);
  mesh.normal_indices = mesh.triangles;
  transform_positions(mesh, to_world, instance);
  for (const std::uint32_t corner : faces.corners)
    if (is_finite(mesh.positions[corner])) bounds.extend(mesh.positions[corner]);
  placed.dropped = drop_degenerate_triangles(mesh);
  drop_unused_vertices(mesh);
  placed.without_normals = fill_zero_normals(mesh);
  return placed;
}

Sphere place_sphere(float radius, const Transform& to_world, const XmlElement& instance,
                    ColladaDocument& document) {
  constexpr double evenness = 1e-4;
  double lengths[3], mean = 0;
  for (int c = 0; c < 3; ++c) {
    lengths[c] = std::sqrt(to_world.m[0][c] * to_world.m[0][c] + to_world.m[1][c] * to_world.m[1][c] +
                           to_world.m[2][c] * to_world.m[2][c]);
    mean += lengths[c] / 3;
  }
  bool even = true;
  for (int c = 0; c < 3; ++c) {
    const int d = (c + 1) % 3;
    double dot = 0;
    for (int row = 0; row < 3; ++row) dot += to_world.m[row][c] * to_world.m[row][d];
    even =
        even && std::fabs(lengths[c] - mean) <= evenness * mean && std::fabs(dot) <= evenness * mean * mean;
  }
  const bool is_cs184 = document.options().interpretation == Interpretation::cs184;
  const double scale = is_cs184 ? lengths[0] : mean;
  if (!even)
    document.warn(
        instance,
        fmt::format("a sphere must be scaled evenly, and is scaled by {:.4g}, {:.4g} and {:.4g}; {} is used",
                    lengths[0], lengths[1], lengths[2], is_cs184 ? "the first" : "the mean"));
  const Sphere sphere{to_world.point({0, 0, 0}), float(radius * scale)};
  if (!is_finite(sphere.center) || !(max_abs(sphere.center) <= max_coordinate) ||
      !(sphere.radius <= max_coordinate))
    instance.fail(fmt::format("this sphere comes to lie beyond +-{:g}", max_coordinate));
  return sphere;
}

}  // namespace twinray

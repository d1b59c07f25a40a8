// SPDX-License-Identifier: Apache-2.0
#include "io/collada/instance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/cs184/normals.h"

namespace twinray {
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

std::vector<DoublePoint> all_transformed(const std::vector<Vec3>& positions, const Transform& t) {
  std::vector<DoublePoint> points;
  points.reserve(positions.size());
  for (const Vec3& p : positions) {
    DoublePoint& point = points.emplace_back();
    for (std::size_t row = 0; row < 3; ++row)
      point[row] = t.m[row][0] * p.x + t.m[row][1] * p.y + t.m[row][2] * p.z + t.m[row][3];
  }
  return points;
}

FailPlacing fail_at(const XmlElement& instance) {
  return [&instance](const std::string& message) { instance.fail(message); };
}

}  // namespace

PlacedMesh place_mesh(const Mesh& local, const Transform& to_world, const XmlElement& instance) {
  return place_mesh(local, to_world, fail_at(instance));
}

PlacedMesh place_cs184_mesh(const ColladaPart& part, const Transform& to_world, const XmlElement& instance,
                            ColladaDocument& document, Aabb& bounds) {
  const FaceList faces = faces_of(part);
  VertexNormals smooth = cs184_normals(faces, all_transformed(part.mesh.positions, to_world));
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
  move_positions(mesh, to_world, fail_at(instance));
  for (const std::uint32_t corner : faces.corners)
    if (is_finite(mesh.positions[corner])) bounds.extend(mesh.positions[corner]);
  clean_up(placed);
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

// SPDX-License-Identifier: Apache-2.0
#include "check/placement.h"

#include <algorithm>
#include <utility>

namespace twinray {
namespace {

/// p scale + shift.
struct Similarity {
  float scale = 1;
  Vec3 shift;

  Vec3 operator()(const Vec3& p) const { return p * scale + shift; }
};

Similarity similarity_of(Placement placement, const Aabb& bounds) {
  const float coordinate = std::max(max_abs(bounds.lower), max_abs(bounds.upper));
  // Half of what may be, so that rounding does not pass it.
  const float room = 0.5f * max_coordinate;
  switch (placement) {
    case Placement::shrunk:
      return {1e-6f, {}};
    case Placement::grown:
      return {coordinate > 0 ? std::clamp(room / coordinate, 1.0f, 1e6f) : 1e6f, {}};
    case Placement::moved: {
      const float distance = std::clamp(room - coordinate, 0.0f, 1e5f * max_abs(bounds.extent()));
      return {1, Vec3{0.74f, -0.31f, 0.89f} * distance};
    }
    default:
      return {};
  }
}

Shape placed(const Mesh& mesh, const Similarity& similarity) {
  Mesh result{.name = mesh.name, .positions = mesh.positions, .triangles = mesh.triangles};
  if (!mesh.is_opaque) {
    result.uvs = mesh.uvs;
    result.uv_indices = mesh.uv_indices;
    result.is_opaque = false;
  }
  for (Vec3& p : result.positions) p = similarity(p);
  drop_degenerate_triangles(result);
  return result;
}

Shape placed(const SphereSet& set, const Similarity& similarity) {
  SphereSet result = set;
  for (Sphere& sphere : result.spheres)
    sphere = {similarity(sphere.center), sphere.radius * similarity.scale};
  return result;
}

}  // namespace

std::shared_ptr<const Geometry> placed_geometry(const std::shared_ptr<const Geometry>& geometry,
                                                Placement placement) {
  if (placement == Placement::file || geometry->bounds().is_empty()) return geometry;
  const Similarity similarity = similarity_of(placement, geometry->bounds());
  std::vector<Shape> shapes;
  for (const Shape& shape : geometry->shapes())
    shapes.push_back(std::visit([&](const auto& s) { return placed(s, similarity); }, shape));
  return std::make_shared<const Geometry>(std::move(shapes), geometry->acceptance());
}

}  // namespace twinray

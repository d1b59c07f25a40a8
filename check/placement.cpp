// SPDX-License-Identifier: Apache-2.0
#include "check/placement.h"

#include <algorithm>
#include <utility>

#include "core/transform.h"

namespace twinray {
namespace {

/// p scale + shift.
struct Similarity {
  float scale = 1;
  Vec3 shift;

  Vec3 operator()(const Vec3& p) const { return p * scale + shift; }
  Transform transform() const {
    return Transform::translation(shift.x, shift.y, shift.z) * Transform::scaling(scale, scale, scale);
  }
};

/// By what instances can be made smaller and larger, so that each still is one.
struct ScaleRange {
  double least = 0, most = Aabb::infinity;

  explicit ScaleRange(const Geometry& geometry) {
    for (std::uint32_t i = 0; i < geometry.instances().size(); ++i) {
      least = std::max(least, 2 * geometry.placed()[i].to_object.stretch() / max_instance_scale);
      most = std::min(most, 0.5 * max_instance_scale / geometry.instances()[i].to_world.stretch());
    }
  }
};

Similarity similarity_of(Placement placement, const Geometry& geometry) {
  const Aabb& bounds = geometry.bounds();
  const ScaleRange scales(geometry);
  const float coordinate = std::max(max_abs(bounds.lower), max_abs(bounds.upper));
  // Half of what may be, so that rounding does not pass it.
  const float room = 0.5f * max_coordinate;
  switch (placement) {
    case Placement::shrunk:
      return {std::max(1e-6f, float(scales.least)), {}};
    case Placement::grown:
      return {std::min(coordinate > 0 ? std::clamp(room / coordinate, 1.0f, 1e6f) : 1e6f, float(scales.most)),
              {}};
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
  const Similarity similarity = similarity_of(placement, *geometry);
  std::vector<Shape> shapes;
  for (const Shape& shape : geometry->shapes())
    if (shapes.size() < geometry->direct_shapes().count)
      shapes.push_back(std::visit([&](const auto& s) { return placed(s, similarity); }, shape));
    else
      shapes.push_back(shape);
  Instancing instancing{geometry->prototypes(), geometry->instances()};
  for (Instance& instance : instancing.instances)
    instance.to_world = similarity.transform() * instance.to_world;
  return std::make_shared<const Geometry>(std::move(shapes), geometry->acceptance(), std::move(instancing));
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "io/collada/lamp.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/aabb.h"

namespace twinray {
namespace {

constexpr float plane_tolerance = 1e-3f, center_tolerance = 0.01f, side_tolerance = 0.01f;

/// A flat lamp by its plane: unit axes, with the third one the normal, and its middle.
struct Plane {
  Vec3 center, x, y, normal;

  Vec3 to_local(const Vec3& p) const {
    const Vec3 d = p - center;
    return {dot(d, x), dot(d, y), dot(d, normal)};
  }
};

Aabb local_box(const Mesh& mesh, const Plane& plane) {
  Aabb box;
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t i : triangle) box.extend(plane.to_local(mesh.positions[i]));
  return box;
}

Vec3 area_vector(const Mesh& mesh, const Triangle& triangle) {
  const Vec3& a = mesh.positions[triangle[0]];
  return cross(mesh.positions[triangle[1]] - a, mesh.positions[triangle[2]] - a);
}

/// Which side of the mesh faces the direction; both where its triangles disagree.
EmissionSide side_towards(const Mesh& mesh, const Vec3& direction) {
  std::size_t front = 0;
  for (const Triangle& triangle : mesh.triangles) front += dot(area_vector(mesh, triangle), direction) > 0;
  if (front == mesh.triangles.size()) return EmissionSide::front;
  return front == 0 ? EmissionSide::back : EmissionSide::both;
}

bool near(float a, float b, float tolerance) { return std::fabs(a - b) <= tolerance; }

bool coincide(const AreaLight& light, const Mesh& mesh, const Plane& plane) {
  const float width = length(light.corners[3] - light.corners[0]),
              height = length(light.corners[1] - light.corners[0]);
  const float size = std::max(width, height);
  const Aabb box = local_box(mesh, plane);
  if (box.is_empty() || std::max(-box.lower.z, box.upper.z) > plane_tolerance * size) return false;
  if (length(box.center()) > center_tolerance * size) return false;
  const Vec3 sides = box.extent();
  const float slack = side_tolerance * size;
  return (near(sides.x, width, slack) && near(sides.y, height, slack)) ||
         (near(sides.x, height, slack) && near(sides.y, width, slack));
}

/// The plane of an area light, its normal towards where the light goes.
Plane plane_of(const AreaLight& light) {
  const Vec3 x = light.corners[3] - light.corners[0], y = light.corners[1] - light.corners[0];
  return {(light.corners[0] + light.corners[2]) * 0.5f, normalize(x), normalize(y), normalize(cross(y, x))};
}

/// The mesh of a part that emits; null: it is none.
const Mesh* lamp_of(const ScenePart& part) {
  return emits(part.glow) ? std::get_if<Mesh>(&part.shape) : nullptr;
}

/// Whether the part is an area light's lamp, on one side.
bool is_lamp_of(const AreaLight& light, const ScenePart& part) {
  const Plane plane = plane_of(light);
  const Mesh* mesh = lamp_of(part);
  return mesh && coincide(light, *mesh, plane) && side_towards(*mesh, plane.normal) != EmissionSide::both;
}

bool merge_area_light(const AreaLight& light, SceneParts& parts) {
  const auto part = std::find_if(parts.shapes.begin(), parts.shapes.end(),
                                 [&](const ScenePart& each) { return is_lamp_of(light, each); });
  if (part == parts.shapes.end()) return false;
  const Mesh& mesh = std::get<Mesh>(part->shape);
  part->glow.radiance = light.radiance;
  part->glow.side = side_towards(mesh, plane_of(light).normal);
  parts.notes.push_back(
      fmt::format("one lamp: the area light \"{}\" and the emissive mesh \"{}\" coincide; the mesh is the "
                  "lamp, with the area "
                  "light's color and side",
                  light.name, mesh.name));
  return true;
}

/// The plane of a flat mesh's first triangle; none where it has no triangle.
std::optional<Plane> plane_of(const Mesh& mesh) {
  if (mesh.triangles.empty()) return std::nullopt;
  const Vec3& a = mesh.positions[mesh.triangles[0][0]];
  const Vec3 x = normalize(mesh.positions[mesh.triangles[0][1]] - a);
  const Vec3 normal = normalize(area_vector(mesh, mesh.triangles[0]));
  return Plane{a, x, cross(normal, x), normal};
}

/// Whether a point of the mesh's plane lies in one of its triangles.
bool lies_within(const Vec3& point, const Mesh& mesh, const Vec3& normal) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& triangle) {
    int left = 0, right = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = mesh.positions[triangle[k]], &b = mesh.positions[triangle[(k + 1) % 3]];
      const float side = dot(cross(b - a, point - a), normal);
      left += side >= 0;
      right += side <= 0;
    }
    return left == 3 || right == 3;
  });
}

bool lies_in(const Vec3& point, const Mesh& mesh) {
  const auto plane = plane_of(mesh);
  if (!plane) return false;
  const Aabb box = local_box(mesh, *plane);
  const float slack = plane_tolerance * std::max(box.extent().x, box.extent().y);
  return std::max(-box.lower.z, box.upper.z) <= slack && std::fabs(plane->to_local(point).z) <= slack &&
         lies_within(point, mesh, plane->normal);
}

bool is_lamp_of(const Light& light, const ScenePart& part) {
  const auto* point = std::get_if<PointLight>(&light.source);
  const Mesh* mesh = lamp_of(part);
  return point && mesh && lies_in(point->position, *mesh);
}

bool merge_point_light(const Light& light, SceneParts& parts) {
  const auto part = std::find_if(parts.shapes.begin(), parts.shapes.end(),
                                 [&](const ScenePart& each) { return is_lamp_of(light, each); });
  if (part == parts.shapes.end()) return false;
  parts.notes.push_back(
      fmt::format("one lamp: the point light \"{}\" lies within the emissive mesh \"{}\"; the mesh is the "
                  "lamp, and the point "
                  "light is left out",
                  light.name, std::get<Mesh>(part->shape).name));
  return true;
}

/// Whether one of the lights has its lamp among the parts.
template <typename AnyLight>
bool has_lamp(const std::vector<AnyLight>& lights, const std::vector<ScenePart>& parts) {
  return std::any_of(lights.begin(), lights.end(), [&](const AnyLight& light) {
    return std::any_of(parts.begin(), parts.end(),
                       [&](const ScenePart& part) { return is_lamp_of(light, part); });
  });
}

}  // namespace

void merge_lamps(SceneParts& parts) {
  std::erase_if(parts.area_lights, [&](const AreaLight& light) { return merge_area_light(light, parts); });
  std::erase_if(parts.lights, [&](const Light& light) { return merge_point_light(light, parts); });
}

bool has_double_lamps(const SceneParts& parts) {
  return has_lamp(parts.area_lights, parts.shapes) || has_lamp(parts.lights, parts.shapes);
}

}  // namespace twinray

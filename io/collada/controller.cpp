// SPDX-License-Identifier: Apache-2.0
#include "io/collada/controller.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "io/collada/skin.h"

namespace twinray {
namespace {

XmlElement skin_or_morph(const XmlElement& controller) {
  for (const char* name : {"skin", "morph"})
    if (const auto found = controller.child(name)) return *found;
  controller.fail("<controller> has neither a <skin> nor a <morph>, of which it needs one");
}

/// The number that the file has for a position of a part.
std::uint32_t vertex_of(const ColladaPart& part, std::uint32_t position) {
  return part.vertices.empty() ? position : part.vertices[position];
}

/// A normal where a transform moves its triangles and leaves their winding: where it mirrors, the front
/// becomes the back.
Vec3 turned_normal(const Transform& transform, const Vec3& normal) {
  const Vec3 front = transform.front(normal);
  return transform.determinant() < 0 ? -front : front;
}

/// Each corner's normal is turned with its vertex: a normal that vertices share becomes one for each.
void turn_normals(ColladaPart& part, const std::vector<Transform>& transforms) {
  Mesh& mesh = part.mesh;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known;
  std::vector<Vec3> turned;
  for (std::size_t t = 0; t < mesh.normal_indices.size(); ++t)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t vertex = vertex_of(part, mesh.triangles[t][corner]);
      std::uint32_t& normal = mesh.normal_indices[t][corner];
      const auto [found, is_new] = known.try_emplace({vertex, normal}, std::uint32_t(turned.size()));
      if (is_new) turned.push_back(turned_normal(transforms[vertex], mesh.normals[normal]));
      normal = found->second;
    }
  mesh.normals = std::move(turned);
}

}  // namespace

PosedGeometry ColladaControllers::pose(const XmlElement& instance) {
  instance_ = instance;
  followed_ = 0;
  chain_.clear();
  PosedGeometry pose = pose_of(document_.resolve(instance, "url", "controller"));
  if (!pose.shape.vertices.empty())
    for (ColladaPart& part : pose.shape.geometry.parts)
      for (std::uint32_t i = 0; i < part.mesh.positions.size(); ++i)
        part.mesh.positions[i] = pose.shape.vertices[vertex_of(part, i)];
  return pose;
}

PosedGeometry ColladaControllers::pose_of(const XmlElement& element) {
  constexpr std::size_t most_followed = 10'000;
  if (++followed_ > most_followed)
    element.fail(fmt::format("controllers lead to more than {} others", most_followed));
  if (element.is("geometry")) return {element, {{}, read_geometry(element, document_)}};
  if (std::find(chain_.begin(), chain_.end(), element) != chain_.end())
    element.fail("this controller is its own source; controllers must form no circle");
  chain_.push_back(element);
  const XmlElement source = skin_or_morph(element);
  PosedGeometry pose = pose_of(document_.resolve(source, "source", "geometry", "controller"));
  if (source.is("skin"))
    apply_skin(pose, source);
  else
    apply_morph(pose, source);
  chain_.pop_back();
  return pose;
}

void ColladaControllers::read_vertices_of(PosedGeometry& pose) {
  if (!pose.shape.vertices.empty()) return;
  std::vector<Vec3> vertices = read_vertices(pose.geometry, document_);
  for (const ColladaPart& part : pose.shape.geometry.parts)
    for (std::uint32_t i = 0; i < part.mesh.positions.size(); ++i)
      if (vertex_of(part, i) >= vertices.size())
        part.element.fail(
            "its <vertices> are not the first ones of its <geometry>, which controllers change");
  pose.shape.vertices = std::move(vertices);
}

void ColladaControllers::apply_skin(PosedGeometry& pose, const XmlElement& skin) {
  try {
    read_vertices_of(pose);
    if (!joints_) joints_.emplace(visual_scene_, document_);
    std::vector<Vec3>& vertices = pose.shape.vertices;
    const auto transforms = skin_transforms(skin, *instance_, vertices.size(), *joints_, document_);
    for (std::size_t i = 0; i < transforms.size(); ++i) vertices[i] = transforms[i].point(vertices[i]);
    for (ColladaPart& part : pose.shape.geometry.parts) turn_normals(part, transforms);
    pose.is_in_scene = true;
    document_.warn(skin, "<skin> stands as its joints do in the file; animations do not move them");
  } catch (const PlacedError& error) {
    document_.warn([&] { return error.place(); },
                   fmt::format("{}; this <skin> is rendered in its bind pose", error.message()));
    pose.to_node = bind_shape(skin, document_) * pose.to_node;
  }
}

void ColladaControllers::apply_morph(PosedGeometry& pose, const XmlElement& morph) {
  const std::ptrdiff_t depth = std::ptrdiff_t(chain_.size());
  try {
    read_vertices_of(pose);
    const MorphTargets morphed = read_morph_targets(morph, document_);
    ControlledShape shape = pose.shape;
    scale(shape, morphed.base_weight);
    for (const auto& [element, weight] : morphed.targets) {
      if (weight == 0) continue;
      PosedGeometry target = pose_of(element);
      read_vertices_of(target);
      if (target.shape.vertices.size() != shape.vertices.size())
        element.fail(fmt::format("this target has {} vertices, and the base mesh {}",
                                 target.shape.vertices.size(), shape.vertices.size()));
      add_scaled(shape, target.shape, weight);
    }
    pose.shape = std::move(shape);
    document_.warn(morph, "<morph> has the weights of the file; animations do not change them");
  } catch (const PlacedError& error) {
    chain_.erase(chain_.begin() + depth, chain_.end());
    document_.warn([&] { return error.place(); },
                   fmt::format("{}; this <morph> is rendered as its base mesh", error.message()));
  }
}

}  // namespace twinray

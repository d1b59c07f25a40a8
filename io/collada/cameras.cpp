// SPDX-License-Identifier: Apache-2.0
#include "io/collada/cameras.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "io/collada/camera.h"
#include "io/collada/layers.h"

namespace twinray {
namespace {

bool has_name(const ColladaCamera& camera, const std::string& name) {
  for (const XmlElement& element : {camera.element, camera.node})
    for (const char* attribute : {"name", "id"})
      if (element.attribute(attribute) == name) return true;
  return false;
}

std::string listed(const std::vector<ColladaCamera>& cameras) {
  if (cameras.empty()) return "the scene has no camera";
  std::vector<std::string> names;
  for (const ColladaCamera& camera : cameras) names.push_back(fmt::format("\"{}\"", camera_name(camera)));
  return fmt::format("the scene has {}", fmt::join(names, ", "));
}

const ColladaCamera& camera_with(const std::string& name, const std::vector<ColladaCamera>& cameras,
                                 const ColladaDocument& document) {
  const auto found = std::find_if(cameras.begin(), cameras.end(),
                                  [&](const ColladaCamera& camera) { return has_name(camera, name); });
  if (found == cameras.end())
    throw Error(fmt::format("{}: no camera, and no node of one, has the name \"{}\"; {}",
                            document.root().document().file(), name, listed(cameras)));
  return *found;
}

struct ClipDistances {
  double near = 0, far = std::numeric_limits<double>::infinity();
};

/// Those of a camera that has some, as numbers; what is wrong with others matters where they are used.
std::optional<ClipDistances> clip_distances(const XmlElement& camera) {
  const XmlElement common = camera.required_child("optics").required_child("technique_common");
  const auto parallel = common.child("orthographic"), perspective = common.child("perspective");
  if (!parallel && !perspective) return std::nullopt;
  const auto near = (parallel ? parallel : perspective)->child("znear"),
             far = (parallel ? parallel : perspective)->child("zfar");
  ClipDistances distances;
  try {
    if (near) distances.near = near->number();
    if (far) distances.far = far->number();
  } catch (const Error&) {
    return std::nullopt;
  }
  return distances;
}

/// Of those in front of the camera.
bool has_vertex_outside(const Geometry& geometry, const Camera& camera, double near, double far) {
  for (const Shape& shape : geometry.shapes()) {
    const Mesh* mesh = std::get_if<Mesh>(&shape);
    if (!mesh) continue;
    for (const Vec3& position : mesh->positions) {
      const double depth = dot(position - camera.position, camera.forward);
      if (depth > 0 && (depth < near || depth > far)) return true;
    }
  }
  return false;
}

}  // namespace

std::string camera_name(const ColladaCamera& camera) {
  const std::string name = display_name(camera.element);
  return name == "unnamed" ? display_name(camera.node) : name;
}

const ColladaCamera* choose_camera(const std::vector<ColladaCamera>& cameras, const XmlElement& visual_scene,
                                   ColladaDocument& document) {
  const std::string& name = document.options().camera_name;
  if (!name.empty()) return &camera_with(name, cameras, document);
  if (cameras.empty()) return nullptr;
  if (document.options().interpretation == Interpretation::cs184) return &cameras.back();
  for (const XmlElement& render : renders_of(visual_scene)) {
    if (!render.attribute("camera_node")) continue;
    const XmlElement node = document.resolve(render, "camera_node", "node");
    for (const ColladaCamera& camera : cameras)
      if (camera.node == node) return &camera;
    document.warn(render, "the <node> that camera_node names has no camera; another one is taken");
  }
  return &cameras[0];
}

Camera place_camera(const ColladaCamera& camera, ColladaDocument& document) {
  return read_camera(camera.element, camera.instance, camera.to_world, camera.unit, document);
}

std::optional<std::string> unused_clip_note(const ColladaCamera& camera, const Scene& scene,
                                            const ColladaDocument& document) {
  const LoadOptions& options = document.options();
  if (options.clip_as_file || options.interpretation == Interpretation::cs184) return std::nullopt;
  const auto range = clip_distances(camera.element);
  if (!range) return std::nullopt;
  const double near = camera.unit * range->near, far = camera.unit * range->far;
  if (!has_vertex_outside(*scene.geometry, scene.camera, near, far)) return std::nullopt;
  return fmt::format(
      "the camera's clip distances, znear {:g} and zfar {:g}, are not used: parts of the scene are nearer or "
      "farther; --clip=file cuts them off",
      range->near, range->far);
}

Cs184View cs184_view_of(const ColladaCamera& camera, ColladaDocument& document) {
  return read_cs184_view(camera.element, camera.instance, camera.to_world, document);
}

}  // namespace twinray

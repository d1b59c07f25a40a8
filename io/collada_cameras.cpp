// SPDX-License-Identifier: Apache-2.0
#include "io/collada_cameras.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/collada_camera.h"
#include "io/collada_layers.h"

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

Cs184View cs184_view_of(const ColladaCamera& camera, ColladaDocument& document) {
  return read_cs184_view(camera.element, camera.instance, camera.to_world, document);
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/camera.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "io/camera_axes.h"
#include "io/gltf/document.h"

namespace twinray {
namespace {

/// Of a frame whose width is left to the picture: below that of any, so that fit_frame() widens it.
constexpr float open_side = 0x1p-20f;

const tinygltf::Camera& source_of(const GltfDocument& document, const GltfCamera& camera) {
  return document.model().cameras[std::size_t(camera.camera)];
}

bool has_name(const GltfDocument& document, const GltfCamera& camera, const std::string& name) {
  return name == camera_name(document, camera) ||
         name == document.model().nodes[std::size_t(camera.node)].name;
}

std::string listed(const GltfDocument& document, const std::vector<GltfCamera>& cameras) {
  if (cameras.empty()) return "the scene has no camera";
  std::vector<std::string> names;
  for (const GltfCamera& camera : cameras)
    names.push_back(fmt::format("\"{}\"", camera_name(document, camera)));
  return fmt::format("the scene has {}", fmt::join(names, ", "));
}

struct Clip {
  double near, far;  ///< far: 0 where there is none.
};

void read_clip(const GltfContext& context, const Clip& clip, const std::string& pointer, Camera& camera) {
  if (!context.options.clip_as_file) return;
  camera.clip_near = float(clip.near);
  if (clip.far > 0) camera.clip_far = float(clip.far);
  if (!(camera.clip_near < camera.clip_far))
    context.fail(pointer, fmt::format("znear is {} and zfar {}; znear must be the smaller one",
                                      camera.clip_near, camera.clip_far));
}

}  // namespace

std::string camera_name(const GltfDocument& document, const GltfCamera& camera) {
  const std::string& own = source_of(document, camera).name;
  const std::string& node = document.model().nodes[std::size_t(camera.node)].name;
  if (!own.empty()) return own;
  return node.empty() ? fmt::format("camera {}", camera.camera) : node;
}

const GltfCamera* choose_camera(const GltfDocument& document, const std::vector<GltfCamera>& cameras) {
  const std::string& name = document.context().options.camera_name;
  if (name.empty()) return cameras.empty() ? nullptr : &cameras[0];
  const auto found = std::find_if(cameras.begin(), cameras.end(),
                                  [&](const GltfCamera& camera) { return has_name(document, camera, name); });
  if (found == cameras.end())
    throw Error(fmt::format("{}: no camera, and no node of one, has the name \"{}\"; {}",
                            document.context().file, name, listed(document, cameras)));
  return &*found;
}

Camera place_camera(const GltfDocument& document, const GltfCamera& placed) {
  const tinygltf::Camera& source = source_of(document, placed);
  const GltfContext& context = document.context();
  const std::string pointer = fmt::format("/cameras/{}", placed.camera);
  Camera camera;
  if (source.type == "orthographic") {
    const auto& lens = source.orthographic;
    if (lens.xmag == 0 || lens.ymag == 0)
      context.fail(pointer + "/orthographic", "xmag and ymag are half the frame; they must not be 0");
    camera.projection = Projection::orthographic;
    // In scene units: the scale of a camera's node is ignored, as the format has it.
    camera.tan_half_width = float(std::fabs(lens.xmag));
    camera.tan_half_height = float(std::fabs(lens.ymag));
    read_clip(context, {lens.znear, lens.zfar}, pointer + "/orthographic", camera);
  } else {
    const auto& lens = source.perspective;
    camera.tan_half_height = float(tan_radians(lens.yfov / 2));
    camera.tan_half_width = camera.tan_half_height * open_side;
    read_clip(context, {lens.znear, lens.zfar}, pointer + "/perspective", camera);
  }
  const CameraAxes axes = camera_axes(placed.to_world);
  if (!axes.fault.empty()) context.fail(fmt::format("/nodes/{}", placed.node), axes.fault);
  camera.right = axes.right, camera.up = axes.up, camera.forward = axes.forward;
  camera.position = placed.to_world.point({0, 0, 0});
  return camera;
}

}  // namespace twinray

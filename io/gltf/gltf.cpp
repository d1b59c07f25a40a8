// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/gltf.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include "io/default_camera.h"
#include "io/gltf/animation.h"
#include "io/gltf/camera.h"
#include "io/gltf/document.h"
#include "io/gltf/instancing.h"
#include "io/gltf/light.h"
#include "io/gltf/nodes.h"
#include "io/gltf/shapes.h"
#include "io/gltf/slot.h"
#include "io/input_file.h"
#include "io/scene_part.h"

namespace twinray {
namespace {

/// Gathers what the nodes of a file put into the scene.
class Builder {
 public:
  explicit Builder(GltfDocument& document)
      : document_(document), materials_(document), shapes_(document, materials_) {}

  LoadedScene build() {
    LoadedScene loaded;
    set_poses(loaded.summary);
    const std::vector<bool> are_visible = visible_nodes(document_);
    for (const int node : shown_nodes(document_)) add_node(node, are_visible[std::size_t(node)]);
    shapes_.place_all();
    if (shapes_.parts.empty()) document_.context().warn("/", "the scene has no shapes");
    loaded.scene = assembled();
    set_camera(loaded);
    add_notes();
    loaded.summary.dropped_triangles = shapes_.dropped_triangles;
    loaded.summary.repeated = shapes_.repeated;
    count_scene(loaded.scene, loaded.summary);
    return loaded;
  }

 private:
  void set_poses(SceneSummary& summary) {
    const std::optional<double> time = document_.context().options.time;
    poses_ = rest_poses(document_);
    if (const auto duration = duration_of(document_)) {
      summary.animation = AnimationSummary{duration->first, duration->last, time};
      if (time) animate(document_, *time, poses_);
    }
    world_ = world_transforms(document_, poses_);
  }

  /// A mesh with a skin is where its joints are, wherever its own node is. Where these mirror it, its place
  /// does that for them: there the front stays the front.
  void add_mesh(int index, const tinygltf::Node& node) {
    GltfDeformation deformation{poses_[std::size_t(index)].weights, {}};
    if (node.skin >= 0) deformation.joints = joint_transforms(document_, node.skin, world_);
    const Transform to_world = deformation.joints.empty() ? world_[std::size_t(index)] : Transform{};
    std::vector<Transform> places = instance_transforms(document_, index, to_world);
    if (are_mirrored(deformation.joints)) {
      const Transform mirror = Transform::scaling(-1, 1, 1);
      for (Transform& joint : deformation.joints) joint = mirror * joint;
      for (Transform& place : places) place = place * mirror;
    }
    shapes_.add(index, places, deformation);
  }

  void add_node(int index, bool is_visible) {
    const tinygltf::Node& node = document_.model().nodes[std::size_t(index)];
    const Transform& to_world = world_[std::size_t(index)];
    if (node.camera >= 0) cameras_.push_back({node.camera, index, to_world});
    if (!is_visible) return;
    if (node.mesh >= 0) add_mesh(index, node);
    const GltfExtension light(node.extensions, "KHR_lights_punctual", "");
    if (!light || document_.context().options.surfaces_only) return;
    if (auto made = read_gltf_light(document_, int(light.number("light", 0)), index, to_world))
      lights_.push_back(std::move(*made));
  }

  Scene assembled() {
    Scene rest;
    rest.lights = std::move(lights_);
    rest.assets = std::move(shapes_.assets);
    rest.materials = std::move(materials_.materials);
    rest.textures = materials_.textures.take();
    return assemble(std::move(shapes_.parts), std::move(rest), std::move(shapes_.instances));
  }

  void set_camera(LoadedScene& loaded) {
    const GltfCamera* chosen = choose_camera(document_, cameras_);
    loaded.scene.camera =
        chosen ? place_camera(document_, *chosen) : default_camera(loaded.scene.geometry->bounds());
    if (chosen) loaded.summary.camera = camera_name(document_, *chosen);
    for (const GltfCamera& camera : cameras_)
      loaded.summary.cameras.push_back(camera_name(document_, camera));
  }

  void add_notes() {
    auto& notes = document_.context().notes;
    if (shapes_.replaced_normals > 0)
      notes.push_back(
          fmt::format("{} shading normals have no direction; those of their triangles stand for them",
                      shapes_.replaced_normals));
    if (!materials_.occluded.empty())
      notes.push_back(fmt::format(
          "occlusion textures are left out, for light is traced: that of \"{}\"{}", materials_.occluded[0],
          materials_.occluded.size() == 1 ? ""
                                          : fmt::format(" and {} more", materials_.occluded.size() - 1)));
  }

  GltfDocument& document_;
  GltfMaterials materials_;
  GltfShapes shapes_;
  std::vector<GltfPose> poses_;
  std::vector<Transform> world_;
  std::vector<GltfCamera> cameras_;
  std::vector<Light> lights_;
};

}  // namespace

LoadedScene read_gltf(std::string bytes, const std::string& name, const LoadOptions& options, GltfRead read) {
  GltfContext context{name, options, read};
  context.read_pictures = !read;
  if (!read) context.read = [](const std::string& path) { return read_input_file(path, "buffer"); };
  GltfDocument document(std::move(bytes), context);
  LoadedScene loaded = Builder(document).build();
  loaded.wants_light = loaded.scene.lights.empty();
  loaded.warnings = context.warnings.items();
  loaded.summary.notes = std::move(context.notes);
  return loaded;
}

LoadedScene load_gltf(const std::string& path, const LoadOptions& options) {
  options.add_file(path);
  return read_gltf(read_input_file(path, "scene file"), path, options);
}

}  // namespace twinray

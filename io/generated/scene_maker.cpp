// SPDX-License-Identifier: Apache-2.0
#include "io/generated/scene_maker.h"

#include <fmt/format.h>

#include <utility>

#include "core/error.h"
#include "io/generated/generated.h"

namespace twinray::generated {

void SceneMaker::add(Mesh mesh, const Rgb& reflectance) { add(std::move(mesh), Lambert{reflectance}); }

void SceneMaker::add(Mesh mesh, const SurfaceModel& model) {
  triangles_ += mesh.triangles.size();
  scene_.materials.push_back({mesh.name, model});
  scene_.bindings.push_back({std::uint32_t(scene_.materials.size() - 1), no_light});
  shapes_.push_back(std::move(mesh));
}

void SceneMaker::add_lamp(Mesh mesh, const Rgb& radiance) {
  const std::string name = mesh.name;
  add(std::move(mesh), Lambert{Rgb{}});
  scene_.bindings.back().light = std::uint32_t(scene_.lights.size());
  add_light(name, MeshLight{std::uint32_t(shapes_.size() - 1), radiance, EmissionSide::front});
}

void SceneMaker::add_light(const std::string& name, LightSource source) {
  scene_.lights.push_back({name, std::move(source)});
}

std::uint32_t SceneMaker::begin_prototype() {
  instancing_.prototypes.push_back({std::uint32_t(shapes_.size()), 0});
  return std::uint32_t(instancing_.prototypes.size() - 1);
}

void SceneMaker::add_instance(std::uint32_t prototype, const Transform& to_world) {
  instancing_.instances.push_back({prototype, to_world});
}

Scene SceneMaker::finish(const Camera& camera) {
  std::vector<ShapeRange>& prototypes = instancing_.prototypes;
  for (std::size_t i = 0; i < prototypes.size(); ++i)
    prototypes[i].count =
        (i + 1 < prototypes.size() ? prototypes[i + 1].first : std::uint32_t(shapes_.size())) -
        prototypes[i].first;
  scene_.geometry =
      std::make_shared<const Geometry>(std::exchange(shapes_, {}), nullptr, std::exchange(instancing_, {}));
  scene_.camera = camera;
  check_scene(scene_);
  return std::move(scene_);
}

Camera camera_of(const View& view) {
  Camera camera;
  camera.position = view.eye;
  camera.forward = normalize(view.target - view.eye);
  camera.right = normalize(cross(camera.forward, {0, 1, 0}));
  camera.up = cross(camera.right, camera.forward);
  camera.tan_half_width = view.tan_half_width;
  camera.tan_half_height = 0.75f * view.tan_half_width;
  return camera;
}

void check_count(const std::string& scene, std::size_t instances) {
  if (instances < 1 || instances > most_triangles)
    throw Error(
        fmt::format("the scene {} of {} instances: it can have 1 to {}", scene, instances, most_triangles));
}

void check_size(const std::string& scene, std::size_t triangles, std::size_t least) {
  if (triangles < least || triangles > most_triangles)
    throw Error(fmt::format("the scene {} of {} triangles: it can have {} to {}", scene, triangles, least,
                            most_triangles));
}

}  // namespace twinray::generated

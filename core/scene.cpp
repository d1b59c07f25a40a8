// SPDX-License-Identifier: Apache-2.0
#include "core/scene.h"

#include <fmt/format.h>

#include "core/error.h"

namespace twinray {
namespace {

void check_light(const Scene& scene, std::size_t index) {
  const std::size_t shapes = scene.geometry->shapes().size();
  const auto* mesh = std::get_if<MeshLight>(&scene.lights[index].source);
  if (mesh && (mesh->shape >= shapes || !scene.geometry->mesh(mesh->shape)))
    throw Error(fmt::format("light {} names shape {}, which is not a mesh", index, mesh->shape));
  const auto* sphere = std::get_if<SphereLight>(&scene.lights[index].source);
  if (sphere && (sphere->shape >= shapes || !scene.geometry->sphere_set(sphere->shape) ||
                 scene.geometry->sphere_set(sphere->shape)->spheres.size() != 1))
    throw Error(
        fmt::format("light {} names shape {}, which is not a set of one sphere", index, sphere->shape));
}

}  // namespace

void check_scene(const Scene& scene) {
  if (scene.bindings.size() != scene.geometry->shapes().size())
    throw Error(
        fmt::format("{} shapes but {} bindings", scene.geometry->shapes().size(), scene.bindings.size()));
  for (std::size_t i = 0; i < scene.bindings.size(); ++i) {
    if (scene.bindings[i].material >= scene.materials.size())
      throw Error(fmt::format("shape {} names material {}; there are {}", i, scene.bindings[i].material,
                              scene.materials.size()));
    if (scene.bindings[i].light != no_light && scene.bindings[i].light >= scene.lights.size())
      throw Error(fmt::format("shape {} names light {}; there are {}", i, scene.bindings[i].light,
                              scene.lights.size()));
  }
  for (std::size_t i = 0; i < scene.lights.size(); ++i) check_light(scene, i);
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "core/scene.h"

#include <fmt/format.h>

#include "core/check_light.h"
#include "core/error.h"
#include "core/textured_material.h"

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
  check_numbers(scene.lights[index].source, fmt::format("light {}", index));
}

void check_material(const Scene& scene, std::size_t index) {
  const Material& material = scene.materials[index];
  const auto* mix = std::get_if<Mix>(&material.model);
  if (mix && (mix->first >= index || mix->second >= index))
    throw Error(fmt::format("material {} mixes materials {} and {}; valid are those before it", index,
                            mix->first, mix->second));
  for (const TextureUse& use : material.textures) {
    if (use.texture >= scene.textures.size())
      throw Error(fmt::format("material {} names texture {}; there are {}", index, use.texture,
                              scene.textures.size()));
    if (!has_input(material.model, use.input))
      throw Error(fmt::format("material {} has a texture for its {}, and its model has none", index,
                              input_name(use.input)));
  }
}

}  // namespace

void check_scene(const Scene& scene) {
  for (std::size_t i = 0; i < scene.materials.size(); ++i) check_material(scene, i);
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
  check_textures(scene.textures);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) check_material(scene, i);
}

}  // namespace twinray

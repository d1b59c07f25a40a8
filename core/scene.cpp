// SPDX-License-Identifier: Apache-2.0
#include "core/scene.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"

namespace twinray {
namespace {

/// Whether the columns of A are unit vectors at right angles, but for the rounding of a file's numbers.
bool is_rotation(const Transform& transform) {
  constexpr double tolerance = 1e-4;
  const auto& m = transform.m;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b <= a; ++b) {
      const double product = m[0][a] * m[0][b] + m[1][a] * m[1][b] + m[2][a] * m[2][b];
      if (!(std::fabs(product - (a == b ? 1 : 0)) <= tolerance)) return false;
    }
  return true;
}

bool is_scale(const Rgb& c) { return is_finite(c) && c.r >= 0 && c.g >= 0 && c.b >= 0; }

void check_environment(const EnvironmentLight& light, std::size_t index) {
  if (!light.map || light.map->pixels.empty())
    throw Error(fmt::format("light {} is an environment without a picture", index));
  if (light.layout == MapLayout::equal_area && light.map->width != light.map->height)
    throw Error(fmt::format("light {} is an equal-area environment of {} x {} pixels; it must be a square",
                            index, light.map->width, light.map->height));
  if (!is_rotation(light.rotation))
    throw Error(fmt::format("light {} is an environment whose rotation also scales or shears", index));
  if (!is_scale(light.scale))
    throw Error(
        fmt::format("light {} is an environment whose scale is ({}, {}, {}); each must be finite and "
                    "not negative",
                    index, light.scale.r, light.scale.g, light.scale.b));
}

void check_material(const Scene& scene, std::size_t index) {
  const auto* mix = std::get_if<Mix>(&scene.materials[index].model);
  if (mix && (mix->first >= index || mix->second >= index))
    throw Error(fmt::format("material {} mixes materials {} and {}; valid are those before it", index,
                            mix->first, mix->second));
}

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
  if (const auto* environment = std::get_if<EnvironmentLight>(&scene.lights[index].source))
    check_environment(*environment, index);
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
}

}  // namespace twinray

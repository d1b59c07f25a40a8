// SPDX-License-Identifier: Apache-2.0
#include "io/scene_part.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/alpha_test.h"

namespace twinray {
namespace {

LightSource shape_light(const ScenePart& part, std::uint32_t shape) {
  if (std::holds_alternative<SphereSet>(part.shape)) return SphereLight{shape, part.glow.radiance};
  MeshLight light = part.glow;
  light.shape = shape;
  return light;
}

/// Those of the scene, and then those of one prototype after the other. Prototypes without shapes, such as
/// those of which all emits, are left out.
Instancing sort_by_prototype(std::vector<ScenePart>& parts, std::vector<Instance> instances) {
  const auto order_of = [](const ScenePart& part) { return part.prototype ? *part.prototype + 1 : 0; };
  std::stable_sort(parts.begin(), parts.end(),
                   [&](const ScenePart& a, const ScenePart& b) { return order_of(a) < order_of(b); });
  std::vector<ShapeRange> prototypes;
  std::map<std::uint32_t, std::uint32_t> numbers;  // By those that the parts have.
  for (std::uint32_t shape = 0; shape < parts.size(); ++shape) {
    if (!parts[shape].prototype) continue;
    if (numbers.try_emplace(*parts[shape].prototype, std::uint32_t(prototypes.size())).second)
      prototypes.push_back({shape, 0});
    ++prototypes.back().count;
  }
  std::erase_if(instances, [&](const Instance& instance) { return numbers.count(instance.prototype) == 0; });
  for (Instance& instance : instances) instance.prototype = numbers.at(instance.prototype);
  return {std::move(prototypes), std::move(instances)};
}

}  // namespace

Scene assemble(std::vector<ScenePart> parts, Scene rest, std::vector<Instance> instances) {
  Instancing instancing = sort_by_prototype(parts, std::move(instances));
  Scene scene = std::move(rest);
  const std::vector<Light> without_shape = std::move(scene.lights);
  scene.lights.clear();
  std::vector<Shape> shapes;
  for (ScenePart& part : parts) {
    ShapeBinding binding{.material = part.material, .alpha = part.alpha, .asset = part.asset};
    if (emits(part.glow)) {
      binding.light = std::uint32_t(scene.lights.size());
      scene.lights.push_back({part.light_name, shape_light(part, std::uint32_t(shapes.size()))});
    }
    scene.bindings.push_back(binding);
    shapes.push_back(std::move(part.shape));
  }
  scene.lights.insert(scene.lights.end(), without_shape.begin(), without_shape.end());
  scene.geometry = std::make_shared<const Geometry>(
      cut_out(std::move(shapes), scene.bindings, scene.textures, std::move(instancing)));
  check_scene(scene);
  return scene;
}

}  // namespace twinray

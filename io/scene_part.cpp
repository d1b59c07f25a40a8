// SPDX-License-Identifier: Apache-2.0
#include "io/scene_part.h"

#include <utility>

#include "core/alpha_test.h"

namespace twinray {
namespace {

LightSource shape_light(const ScenePart& part, std::uint32_t shape) {
  if (std::holds_alternative<SphereSet>(part.shape)) return SphereLight{shape, part.radiance};
  return MeshLight{shape, part.radiance, part.side, part.picture};
}

}  // namespace

Scene assemble(std::vector<ScenePart> parts, Scene rest) {
  Scene scene = std::move(rest);
  const std::vector<Light> without_shape = std::move(scene.lights);
  scene.lights.clear();
  std::vector<Shape> shapes;
  for (ScenePart& part : parts) {
    ShapeBinding binding{.material = part.material, .alpha = part.alpha, .asset = part.asset};
    if (!is_black(part.radiance)) {
      binding.light = std::uint32_t(scene.lights.size());
      scene.lights.push_back({part.light_name, shape_light(part, std::uint32_t(shapes.size()))});
    }
    scene.bindings.push_back(binding);
    shapes.push_back(std::move(part.shape));
  }
  scene.lights.insert(scene.lights.end(), without_shape.begin(), without_shape.end());
  scene.geometry =
      std::make_shared<const Geometry>(cut_out(std::move(shapes), scene.bindings, scene.textures));
  check_scene(scene);
  return scene;
}

}  // namespace twinray

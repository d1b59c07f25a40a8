// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/scene.h"
#include "io/collada_light.h"

namespace twinray {

/// A shape in the making, with what it wears and what it emits.
struct ScenePart {
  Shape shape;
  std::uint32_t material = 0;
  Rgb radiance;  ///< Black: no light.
  EmissionSide side = EmissionSide::both;
  std::string light_name;
  std::uint32_t asset = no_asset;  ///< The outermost node that it belongs to.
};

/// What the nodes of a scene have given so far, in their order.
struct SceneParts {
  std::vector<ScenePart> shapes;
  std::vector<AreaLight> area_lights;
  std::vector<Light> lights;        ///< Those without a shape.
  std::vector<std::string> assets;  ///< The names of the outermost nodes.
  std::vector<std::string> notes;
  Aabb bounds;  ///< Of all meshes and spheres; gathered where CS184's camera needs it.
};

}  // namespace twinray

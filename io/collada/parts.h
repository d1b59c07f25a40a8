// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "io/collada/light.h"
#include "io/scene_part.h"

namespace twinray {

/// What the nodes of a scene have given so far, in their order.
struct SceneParts {
  std::vector<ScenePart> shapes;
  std::vector<Instance> instances;  ///< Of the shapes' prototypes.
  std::vector<AreaLight> area_lights;
  std::vector<Light> lights;        ///< Those without a shape.
  std::vector<std::string> assets;  ///< The names of the outermost nodes, which shapes belong to.
  std::vector<std::string> notes;
  Aabb bounds;  ///< Of all meshes and spheres; gathered where CS184's camera needs it.
};

}  // namespace twinray

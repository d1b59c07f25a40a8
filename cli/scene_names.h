// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "core/layer.h"
#include "core/scene.h"

namespace twinray {

/// What the numbers in a picture's layers stand for; each list in the scene's order.
struct SceneNames {
  std::vector<std::string> objects, materials, assets;
  std::vector<std::string> light_groups;
};

/// For films that keep more than colours; else none. Things without a name are called by their numbers, from
/// 1 on: "object 3". Behind the assets stand all objects, as asset_of() counts.
SceneNames scene_names(const Scene& scene, const FilmContents& contents);

}  // namespace twinray

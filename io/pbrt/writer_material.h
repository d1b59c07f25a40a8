// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "io/pbrt/writer_texture.h"
#include "io/written_scene.h"

namespace twinray {

/// The materials that shapes have, as named ones.
struct PbrtMaterialTexts {
  std::vector<std::string> names;  ///< One for each of the scene's; empty of one that no shape has.
  std::string text;
};
PbrtMaterialTexts pbrt_materials(const Scene& scene, PbrtTextureWriter& textures, SceneOutput& output);

}  // namespace twinray

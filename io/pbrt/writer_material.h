// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "io/pbrt/writer_texture.h"
#include "io/written_scene.h"

namespace twinray {

/// The materials that shapes have, as named ones, and the media within them.
struct PbrtMaterialTexts {
  std::vector<std::string> names;     ///< One for each of the scene's; empty of one that no shape has.
  std::vector<std::string> interior;  ///< A statement for shapes of the material; mostly empty.
  std::string text;
  std::string atmosphere;  ///< The name of the medium around all shapes, if there is one,
  std::string view;        ///< and the statements that put the camera and all shapes into it.
};
PbrtMaterialTexts pbrt_materials(const Scene& scene, PbrtTextureWriter& textures, SceneOutput& output);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// A scene in a form that small scripts read: one JSON file, and beside it a PLY file for each mesh and an EXR
// file for each picture of a texture or light. docs/exchange.md describes it.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/pixel_filter.h"
#include "core/scene.h"
#include "io/written_scene.h"

namespace twinray {

/// The picture that a scene is meant for: its size in pixels, and what its file says of it besides.
struct ExchangePicture {
  int width = 480, height = 360;
  std::optional<std::uint32_t> samples = {};
  std::optional<int> max_depth = {};
  std::optional<PixelFilter> filter = {};
  std::optional<std::array<int, 4>> crop = {};  ///< As RenderDefaults has it,
  std::optional<double> daylight_kelvin = {};   ///< and this.
};

/// The words for them in that file: "lambert", "thin_dielectric", ..., and "mesh", "point", ...
std::string type_of(const SurfaceModel& model);
std::string type_of(const LightSource& source);

/// The text of the JSON file. The camera's frame is widened to that of the picture (core/camera.h). A number
/// has as many digits as tell it from any other float.
std::string exchange_json(const Scene& scene, const std::string& path, const ExchangePicture& picture);

/// The files of a scene: those of its meshes, textures and lights, and last the JSON file, `path`.
WrittenScene written_exchange(const SceneToWrite& input, const std::string& path);

}  // namespace twinray

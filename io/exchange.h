// SPDX-License-Identifier: Apache-2.0
// A scene in a form that small scripts read: one JSON file, and beside it a PLY file for each mesh and an EXR
// file for each environment. docs/exchange.md describes it.
#pragma once
#include <string>
#include <vector>

#include "core/scene.h"

namespace twinray {

/// The size in pixels of the picture that the scene's camera is meant for.
struct ExchangeFrame {
  int width = 480, height = 360;
};

/// Throws Error unless the name ends in .json, and is more than that.
void check_exchange_name(const std::string& path);

/// The words for them in that file: "lambert", "thin_dielectric", ..., and "mesh", "point", ...
std::string type_of(const SurfaceModel& model);
std::string type_of(const LightSource& source);

/// All files of a scene: those of its meshes and environments, and last the JSON file, `path`.
std::vector<std::string> exchange_files(const Scene& scene, const std::string& path);

/// The text of the JSON file. The camera's frame is widened to that of the picture (core/camera.h). A number
/// has as many digits as tell it from any other float.
std::string exchange_json(const Scene& scene, const std::string& path, const ExchangeFrame& frame);

/// Writes exchange_files(), the JSON file last: where it is, all is there. Each is written as a whole
/// (io/output_file.h). Throws Error.
void write_exchange(const Scene& scene, const std::string& path, const ExchangeFrame& frame);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Scene files by their extension, and generated scenes by their names: the one door for whoever wants a
// scene.
#pragma once
#include <string>
#include <vector>

#include "core/scene.h"
#include "io/diagnostic.h"
#include "io/load_options.h"
#include "io/scene_summary.h"

namespace twinray {

struct LoadedScene {
  Scene scene;  ///< Checked by check_scene().
  std::vector<Diagnostic> warnings;
  SceneSummary summary;
};

/// Reads a scene file: COLLADA 1.4 (.dae); or makes a generated scene (io/generated/generated.h) of a name
/// such as "generated:ball". Throws Error, with the place in the file and what would be valid.
LoadedScene load_scene(const std::string& path, const LoadOptions& options = {});

/// The extensions that load_scene reads, with their dots.
std::vector<std::string> scene_extensions();

}  // namespace twinray

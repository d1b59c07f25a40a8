// SPDX-License-Identifier: Apache-2.0
// Scene files by their extension, and generated scenes by their names: the one door for whoever wants a
// scene.
#pragma once
#include <string>
#include <vector>

#include "io/load_options.h"
#include "io/loaded_scene.h"

namespace twinray {

/// Reads a scene file: COLLADA 1.4 or 1.5 (.dae, .zae); or makes a generated scene (io/generated/generated.h)
/// of a name such as "generated:ball". Throws Error, with the place in the file and what would be valid.
LoadedScene load_scene(const std::string& path, const LoadOptions& options = {});

/// The extensions that load_scene reads, with their dots.
std::vector<std::string> scene_extensions();

}  // namespace twinray

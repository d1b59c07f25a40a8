// SPDX-License-Identifier: Apache-2.0
// What Assimp does here, in a library that is loaded when a scene needs it.
#pragma once
#include <string>

#include "io/load_options.h"
#include "io/loaded_scene.h"

namespace twinray {

/// Reads a scene of a format that Assimp knows by its extension, such as ".stl". Throws Error, which begins
/// with the path, where it is none, or where Assimp cannot be loaded.
LoadedScene import_scene(const std::string& path, const LoadOptions& options);

/// Loads Assimp where that has not been done. Throws Error where it cannot be loaded.
void load_scene_importer();

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Private: scenes of Wavefront OBJ files.
#pragma once
#include <string>

#include "io/load_options.h"
#include "io/loaded_scene.h"
#include "io/obj/reader.h"

namespace twinray {

/// Reads a Wavefront OBJ file with its MTL files. The format has neither cameras nor lights but surfaces that
/// emit. Throws Error, with the place in the file and what would be valid.
LoadedScene load_obj(const std::string& path, const LoadOptions& options = {});

/// The scene of what was read.
LoadedScene make_scene(const ObjModel& model, const LoadOptions& options, WarningList& warnings);

}  // namespace twinray

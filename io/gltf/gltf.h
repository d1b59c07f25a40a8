// SPDX-License-Identifier: Apache-2.0
// Scenes of glTF 2.0 (Khronos Group, "glTF 2.0 Specification", 2.0.1, 2021). What the reader makes of each
// part: docs/gltf.md.
#pragma once
#include <string>

#include "io/gltf/context.h"
#include "io/load_options.h"
#include "io/loaded_scene.h"

namespace twinray {

/// Reads the bytes of a .gltf or .glb file; `name` stands for it in messages, and says where the files lie
/// that it names. These are read by `read`, if it is set, and their pictures are not; else from disk. Throws
/// Error with a JSON pointer.
LoadedScene read_gltf(std::string bytes, const std::string& name, const LoadOptions& options = {},
                      GltfRead read = {});

/// The same of a file on disk.
LoadedScene load_gltf(const std::string& path, const LoadOptions& options = {});

}  // namespace twinray

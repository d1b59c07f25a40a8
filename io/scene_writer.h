// SPDX-License-Identifier: Apache-2.0
// Scenes as files of other programs, by the ending of their names: the one door for whoever writes a scene.
#pragma once
#include <string>

#include "io/written_scene.h"

namespace twinray {

/// Throws Error unless the name ends in one of those that are written, and is more than that.
void check_scene_output(const std::string& path);

/// The files of a scene: in exchange form (.json, io/exchange/writer.h), in pbrt-v4's (.pbrt), in glTF 2.0
/// (.gltf, .glb). docs/convert.md says what becomes of what. Nothing is written yet. Throws Error for another
/// ending.
WrittenScene written_scene(const SceneToWrite& input, const std::string& path);

/// Writes them, in their order. Throws Error.
void write_files(const WrittenScene& written);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "io/written_scene.h"

namespace twinray {

/// A scene as pbrt-v4 has it, the inverse of io/pbrt/scene.h: a text of this name, beside it a binary PLY
/// file for each mesh and an EXR file for each picture. Only what pbrt itself knows is written.
WrittenScene written_pbrt(const SceneToWrite& input, const std::string& path);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "io/written_scene.h"

namespace twinray {

/// A scene in glTF 2.0, the inverse of io/gltf/gltf.h. Of a name that ends in .gltf: a text, beside it a file
/// of all numbers (.bin) and a PNG file for each picture; of one that ends in .glb one file with all of
/// these.
WrittenScene written_gltf(const SceneToWrite& input, const std::string& path);

}  // namespace twinray

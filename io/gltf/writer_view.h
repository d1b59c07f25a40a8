// SPDX-License-Identifier: Apache-2.0
// Private to the writer of glTF: the camera, and lights without a shape, each with its node.
#pragma once
#include "io/gltf/writer_file.h"

namespace twinray {

/// The camera's frame is widened to the picture's.
void add_gltf_camera(const SceneToWrite& input, GltfFile& file);

/// Those that KHR_lights_punctual has, or something near; the others are named.
void add_gltf_lights(const Scene& scene, GltfFile& file);

}  // namespace twinray

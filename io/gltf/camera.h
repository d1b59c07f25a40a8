// SPDX-License-Identifier: Apache-2.0
// A glTF file may have several cameras. One of them makes the picture.
#pragma once
#include <string>
#include <vector>

#include "core/camera.h"
#include "core/transform.h"

namespace twinray {

class GltfDocument;

/// A camera where its node puts it.
struct GltfCamera {
  int camera = 0, node = 0;  ///< Indices into the file's cameras and nodes.
  Transform to_world;
};

/// Its name; where it has none that of its node; else "camera 0".
std::string camera_name(const GltfDocument& document, const GltfCamera& camera);

/// The camera that LoadOptions::camera_name means, by its name or its node's; without such a name the first
/// one. Null where there is none. Throws Error, with the names that there are, for a name that none has.
const GltfCamera* choose_camera(const GltfDocument& document, const std::vector<GltfCamera>& cameras);

/// The camera of the scene: it keeps its height whatever the picture's shape. Throws Error for a node that
/// gives it no direction.
Camera place_camera(const GltfDocument& document, const GltfCamera& camera);

}  // namespace twinray

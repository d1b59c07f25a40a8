// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "core/camera.h"

namespace twinray {

/// Reads the camera settings file that CS184's program writes: white space between the numbers
/// hFov vFov aspect nClip fClip, position (3), target (3), phi theta r minR maxR, the camera-to-world
/// rotation (3 x 3, row by row; its columns are the camera's right, up and backward axes), screenW screenH
/// screenDist, focalDistance lensRadius. Fields of view are in degrees. Field, position, rotation and clip
/// distances are used; the frame keeps the picture's size, and the lens stays as it is in `scene_camera`.
/// Throws Error with line and column.
Camera load_camera_file(const std::string& path, const Camera& scene_camera);

/// The camera that such a file's text describes; `name` stands for the file in messages.
Camera parse_camera(std::string contents, const std::string& name, const Camera& scene_camera);

}  // namespace twinray

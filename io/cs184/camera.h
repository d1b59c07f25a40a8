// SPDX-License-Identifier: Apache-2.0
// The camera of CS184's program. Of a scene file it takes the direction and the lens alone: the camera looks
// at the middle of the box around all meshes and spheres, from 1.5 times the box's diagonal. A larger picture
// shows more of the scene, not more of its detail: a pixel is always the same part of a frame of 800 x 600.
#pragma once
#include <string>

#include "core/aabb.h"
#include "core/camera.h"

namespace twinray {

/// What CS184's program keeps of a camera in a file. The defaults are those of a file without a camera.
struct Cs184View {
  /// From the world's origin to the point one unit in front of the camera's node; of any length. (0, 0, 0)
  /// stands for (0, 0, 1).
  double direction[3] = {0, 0, 0};
  /// Of half the frame's angles, before it is fitted to 4:3: 50 and 35 degrees.
  double tan_half_width = 0.46630765815499859, tan_half_height = 0.31529878887898349;
  float clip_near = 0.01f, clip_far = 100;  ///< Distances along each ray.
};

/// The camera on the side of `box` that the direction points to, looking back at its middle, with its frame
/// fitted to 800 x 600. An empty box counts as one around the origin whose diagonal is 1.
Camera cs184_camera(const Cs184View& view, const Aabb& box);

/// That camera for a picture of this size: the frame of 800 x 600, cut or widened around its middle.
Camera cs184_frame(const Camera& camera, int width, int height);

/// Reads a camera settings file (io/camera_file.h) as CS184's program does: the frame is what the file's
/// angles say, stretched to the picture's shape whatever that is, and the clip distances count along each
/// ray. The lens stays as it is in `scene_camera`. Throws Error.
Camera load_cs184_camera_file(const std::string& path, const Camera& scene_camera);

}  // namespace twinray

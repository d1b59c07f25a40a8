// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "core/transform.h"

namespace twinray {

/// The axes of a camera in a node's space, which looks along -z with y up: orthonormal in the world.
struct CameraAxes {
  Vec3 right, up, forward;
  bool is_up_made = false;  ///< The transform flattens y; up is made of the other two axes.
  std::string fault;        ///< Why there are none; empty where there are.
};

/// Gram and Schmidt's way: the direction of view stays, then up. A camera that is mirrored stays mirrored.
CameraAxes camera_axes(const Transform& to_world);

/// How much the transform stretches along x (0), y (1) or z (2); 1 where it is flat.
double frame_scale(const Transform& to_world, int axis);

}  // namespace twinray

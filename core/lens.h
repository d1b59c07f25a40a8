// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/camera.h"
#include "core/sampler.h"
#include "core/warp.h"

namespace twinray {

/// The camera's ray through a point of the frame, from a random point of its lens: uniform by area, and drawn
/// from the sampler of vertex 0. A pinhole draws nothing.
inline Ray lens_ray(const Camera& camera, Vec2 frame, const VertexSampler& sampler) {
  if (camera.lens_radius == 0) return camera_ray(camera, frame, {});
  return camera_ray(camera, frame, square_to_disc(sampler.draw_2d(Purpose::lens)));
}

}  // namespace twinray

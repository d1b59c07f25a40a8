// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/camera.h"
#include "core/sampler.h"
#include "core/warp.h"

namespace twinray {

/// A point of the camera's lens of radius 1, uniform by area for u uniform in [0, 1)^2.
inline Vec2 lens_point(const Camera& camera, Vec2 u) {
  if (camera.aperture_blades == 0) return square_to_disc(u);
  return square_to_polygon(u, camera.aperture_blades, camera.aperture_turns);
}

/// The camera's ray through a point of the frame, from a random point of its lens: uniform by area, and drawn
/// from the sampler of vertex 0. A pinhole draws nothing.
inline Ray lens_ray(const Camera& camera, Vec2 frame, const VertexSampler& sampler) {
  if (camera.lens_radius == 0) return camera_ray(camera, frame, {});
  return camera_ray(camera, frame, lens_point(camera, sampler.draw_2d(Purpose::lens)));
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "core/camera.h"

namespace twinray {

Camera fit_frame(const Camera& camera, int width, int height) {
  Camera fitted = camera;
  const float aspect = float(width) / float(height);
  if (camera.tan_half_width < camera.tan_half_height * aspect)
    fitted.tan_half_width = camera.tan_half_height * aspect;
  else
    fitted.tan_half_height = camera.tan_half_width / aspect;
  return fitted;
}

Ray camera_ray(const Camera& camera, Vec2 frame, Vec2 lens) {
  const float x = (2 * frame.x - 1) * camera.tan_half_width;
  const float y = (1 - 2 * frame.y) * camera.tan_half_height;
  const Vec3 through = camera.forward + camera.right * x + camera.up * y;
  if (camera.lens_radius == 0)
    return {
        .origin = camera.position, .direction = through, .t_min = camera.clip_near, .t_max = camera.clip_far};
  const Vec3 shift = camera.right * (lens.x * camera.lens_radius) + camera.up * (lens.y * camera.lens_radius);
  return {.origin = camera.position + shift,
          .direction = through - shift / camera.focal_distance,
          .t_min = camera.clip_near,
          .t_max = camera.clip_far};
}

}  // namespace twinray

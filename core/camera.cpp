// SPDX-License-Identifier: Apache-2.0
#include "core/camera.h"

#include <algorithm>
#include <cmath>

#include "core/box_corners.h"

namespace twinray {
namespace {

constexpr float margin = 1.04f;

/// An orthographic camera that has the box in front of it and in its frame.
Camera parallel_view(const Camera& camera, const Aabb& box) {
  float across = 0, depth = 0;  // of the box's corners, as parts of the frame, and along the view
  for (const Vec3& corner : corners_of(box)) {
    const Vec3 p = corner - box.center();
    across = std::max({across, std::fabs(dot(p, camera.right)) / camera.tan_half_width,
                       std::fabs(dot(p, camera.up)) / camera.tan_half_height});
    depth = std::max(depth, -dot(p, camera.forward));
  }
  Camera moved = camera;
  if (across > 0) moved.tan_half_width *= margin * across, moved.tan_half_height *= margin * across;
  moved.position = box.center() - camera.forward * (margin * depth);
  return moved;
}

Camera perspective_view(const Camera& camera, const Aabb& box) {
  float distance = 0;  // of the box's centre, such that |x| <= tan_half depth for each corner
  for (const Vec3& corner : corners_of(box)) {
    const Vec3 p = corner - box.center();
    const float across = std::max(std::fabs(dot(p, camera.right)) / camera.tan_half_width,
                                  std::fabs(dot(p, camera.up)) / camera.tan_half_height);
    distance = std::max(distance, margin * across - dot(p, camera.forward));
  }
  Camera moved = camera;
  moved.position = box.center() - camera.forward * distance;
  return moved;
}

}  // namespace

Camera without_clip(const Camera& camera) {
  Camera open = camera;
  open.clip_near = 0;
  open.clip_far = std::numeric_limits<float>::infinity();
  return open;
}

Camera view_whole(const Camera& camera, const Aabb& box) {
  if (box.is_empty()) return camera;
  return without_clip(camera.is_orthographic ? parallel_view(camera, box) : perspective_view(camera, box));
}

Camera fit_frame(const Camera& camera, int width, int height) {
  if (camera.is_stretched) return camera;
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
  const bool is_parallel = camera.is_orthographic;
  const Vec3 through = is_parallel ? camera.forward : camera.forward + camera.right * x + camera.up * y;
  Ray ray{.origin = is_parallel ? camera.position + camera.right * x + camera.up * y : camera.position,
          .direction = through,
          .t_min = camera.clip_near,
          .t_max = camera.clip_far};
  if (camera.lens_radius != 0) {
    const Vec3 shift =
        camera.right * (lens.x * camera.lens_radius) + camera.up * (lens.y * camera.lens_radius);
    ray.origin = ray.origin + shift;
    ray.direction = through - shift / camera.focal_distance;
  }
  if (camera.clips_by_distance) {
    const float unit = length(ray.direction);
    ray.t_min /= unit;
    ray.t_max /= unit;
  }
  return ray;
}

}  // namespace twinray

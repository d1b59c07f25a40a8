// SPDX-License-Identifier: Apache-2.0
#include "core/camera.h"

#include <algorithm>
#include <cmath>

#include "core/box_corners.h"
#include "core/direction_map.h"
#include "core/elementary.h"
#include "core/warp.h"

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
  moved.frame_center = {0, 0};
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
  moved.frame_center = {0, 0};
  moved.position = box.center() - camera.forward * distance;
  return moved;
}

Camera panoramic_view(const Camera& camera, const Aabb& box) {
  Camera moved = camera;
  moved.position = box.center();
  return moved;
}

SinCos sincos_radians(float radians) {
  const float turns = radians * float(turns_per_radian);
  return sincos_turns(turns - std::floor(turns));
}

/// A direction in the camera's axes: to the right, up and forward.
Vec3 latitude_longitude_direction(float x, float y) {
  const SinCos longitude = sincos_radians(x), latitude = sincos_radians(y);
  return {latitude.cos * longitude.sin, latitude.sin, latitude.cos * longitude.cos};
}

Vec3 fisheye_direction(float x, float y) {
  const float angle = std::sqrt(x * x + y * y);
  if (angle == 0) return {0, 0, 1};
  const SinCos to_axis = sincos_radians(angle);
  return {to_axis.sin * (x / angle), to_axis.sin * (y / angle), to_axis.cos};
}

/// pbrt's square lies around the camera's up.
Vec3 equal_area_view(Vec2 frame) {
  const Vec3 d = wrapped_direction({frame.x, frame.y});
  return {d.x, d.z, d.y};
}

/// In the frame's units, to the right and up of the axis.
Vec2 point_of_frame(const Camera& camera, Vec2 frame) {
  return {(2 * frame.x - 1) * camera.tan_half_width + camera.frame_center.x,
          (1 - 2 * frame.y) * camera.tan_half_height + camera.frame_center.y};
}

/// A point of the camera's lens of radius 1, uniform by area for u uniform in [0, 1)^2.
Vec2 lens_point(const Camera& camera, Vec2 u) {
  if (camera.aperture_blades == 0) return square_to_disc(u);
  return square_to_polygon(u, camera.aperture_blades, camera.aperture_turns);
}

/// The picture on the film is upside down.
LensRay lens_system_ray(const Camera& camera, Vec2 frame, Vec2 u) {
  const Vec2 seen = point_of_frame(camera, frame);
  const auto distance = float(camera.lenses->image_distance());
  const LensSystem::Sight sight = camera.lenses->sight({-seen.x * distance, -seen.y * distance}, u);
  const auto in_world = [&](const Vec3& v) {
    return camera.right * v.x + camera.up * v.y + camera.forward * v.z;
  };
  // So t counts depth from the film, or distance from that plane; what lies before the lens is not seen.
  const float forward = sight.direction.z, unit = camera.clips_by_distance ? 1 : forward;
  if (!(forward > 0)) return {{}, 0};
  return {{.origin = camera.position + in_world(sight.origin - sight.direction * (sight.origin.z / forward)),
           .direction = in_world(sight.direction) / unit,
           .t_min = std::max(camera.clip_near, sight.origin.z / forward * unit),
           .t_max = camera.clip_far},
          sight.light};
}

Ray panorama_ray(const Camera& camera, Vec2 frame, float x, float y) {
  const bool is_fisheye = camera.projection == Projection::fisheye;
  const Vec3 d = is_fisheye                                    ? fisheye_direction(x, y)
                 : camera.projection == Projection::equal_area ? equal_area_view(frame)
                                                               : latitude_longitude_direction(x, y);
  const float edge = std::min(camera.tan_half_width, camera.tan_half_height);
  const bool is_beside = is_fisheye && !(x * x + y * y <= edge * edge);
  return {.origin = camera.position,
          .direction = camera.right * d.x + camera.up * d.y + camera.forward * d.z,
          .t_min = camera.clip_near,
          .t_max = is_beside ? -1 : camera.clip_far};
}

}  // namespace

std::string projection_name(Projection projection) {
  constexpr const char* names[] = {"perspective", "orthographic", "latitude-longitude", "fisheye",
                                   "equal-area"};
  return names[std::size_t(projection)];
}

Camera without_clip(const Camera& camera) {
  Camera open = camera;
  open.clip_near = 0;
  open.clip_far = std::numeric_limits<float>::infinity();
  return open;
}

Camera view_whole(const Camera& camera, const Aabb& box) {
  if (box.is_empty()) return camera;
  if (is_panorama(camera.projection)) return without_clip(panoramic_view(camera, box));
  const bool is_parallel = camera.projection == Projection::orthographic;
  return without_clip(is_parallel ? parallel_view(camera, box) : perspective_view(camera, box));
}

Camera with_panorama(const Camera& camera, Projection panorama, float half_field) {
  Camera around = camera;
  around.projection = panorama;
  around.frame_center = {0, 0};
  around.lens_radius = 0;
  around.lenses = nullptr;
  around.is_stretched = panorama != Projection::fisheye;
  around.tan_half_width = around.tan_half_height = half_field;
  if (panorama == Projection::equal_area) around.tan_half_width = around.tan_half_height = std::sqrt(pi);
  if (panorama == Projection::latitude_longitude) around.tan_half_width = pi, around.tan_half_height = pi / 2;
  return around;
}

Camera fit_frame(const Camera& camera, int width, int height) {
  return fit_frame(camera, float(width) / float(height));
}

Camera fit_frame(const Camera& camera, float aspect) {
  if (camera.is_stretched) return camera;
  Camera fitted = camera;
  if (camera.tan_half_width < camera.tan_half_height * aspect)
    fitted.tan_half_width = camera.tan_half_height * aspect;
  else
    fitted.tan_half_height = camera.tan_half_width / aspect;
  return fitted;
}

Ray camera_ray(const Camera& camera, Vec2 frame, Vec2 lens) {
  const auto [x, y] = point_of_frame(camera, frame);
  if (is_panorama(camera.projection)) return panorama_ray(camera, frame, x, y);
  const bool is_parallel = camera.projection == Projection::orthographic;
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

LensRay lens_ray(const Camera& camera, Vec2 frame, Vec2 u) {
  if (camera.lenses) {
    const LensRay made = lens_system_ray(camera, frame, u);
    if (made.light > 0) return made;
    return {camera_ray(camera, frame, {}), 0};
  }
  return {camera_ray(camera, frame, camera.lens_radius == 0 ? Vec2{} : lens_point(camera, u))};
}

}  // namespace twinray

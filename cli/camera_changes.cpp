// SPDX-License-Identifier: Apache-2.0
#include "cli/camera_changes.h"

#include <fmt/format.h>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/error.h"

namespace twinray {
namespace {

constexpr float usual_fisheye_degrees = 180;

/// The frame's middle, which stays as many parts of the frame aside: tangents and scene units are no measure
/// of each other.
Vec2 center_in_other_units(const Camera& from, const Camera& to, double aspect) {
  const Camera shown = fit_frame(from, float(aspect));
  return {from.frame_center.x / shown.tan_half_width * to.tan_half_width,
          from.frame_center.y / shown.tan_half_height * to.tan_half_height};
}

/// Half of the frame's height, and as much of its width as the picture's shape has.
Camera with_half_height(const Camera& camera, Projection projection, float half, double aspect) {
  Camera made = camera;
  made.lenses = nullptr;
  made.projection = projection;
  made.is_stretched = false;
  made.tan_half_height = half;
  made.tan_half_width = float(half * aspect);
  if (projection != camera.projection) made.frame_center = center_in_other_units(camera, made, aspect);
  return made;
}

Camera with_parallel_rays(const Camera& camera, const AskedProjection& asked, const Aabb& box,
                          double aspect) {
  if (asked.size) return with_half_height(camera, Projection::orthographic, *asked.size / 2, aspect);
  if (camera.projection == Projection::orthographic) return camera;
  const float depth = box.is_empty() ? 1 : dot(box.center() - camera.position, camera.forward);
  if (is_panorama(camera.projection) || !(depth > 0))
    throw UsageError(
        "--projection=orthographic: the camera does not look at the scene, so the frame's height must be "
        "given, in scene units, as in orthographic:2");
  Camera parallel = camera;
  parallel.lenses = nullptr;
  parallel.projection = Projection::orthographic;
  parallel.tan_half_width *= depth;
  parallel.tan_half_height *= depth;
  parallel.frame_center = {camera.frame_center.x * depth, camera.frame_center.y * depth};
  return parallel;
}

void refuse_for_panorama(bool is_given, const char* option, const Camera& camera) {
  if (is_given && is_panorama(camera.projection))
    throw UsageError(fmt::format("{} goes with perspective and orthographic cameras; this one is {}", option,
                                 projection_name(camera.projection)));
}

}  // namespace

Camera with_projection(const Camera& camera, const AskedProjection& asked, const Aabb& box, double aspect) {
  switch (asked.projection) {
    case Projection::perspective:
      return with_half_height(camera, Projection::perspective,
                              float(tan_radians(double(*asked.size * float(radians_per_degree) / 2))),
                              aspect);
    case Projection::orthographic:
      return with_parallel_rays(camera, asked, box, aspect);
    default:
      return with_panorama(camera, asked.projection,
                           asked.size.value_or(usual_fisheye_degrees) * float(radians_per_degree) / 2);
  }
}

Camera changed(const Camera& camera, const CameraChanges& changes, const Camera& fitted) {
  refuse_for_panorama(changes.lens.has_value(), "--lens", camera);
  refuse_for_panorama(changes.shift.has_value(), "--lens-shift", camera);
  Camera made = camera;
  if (changes.shift)
    made.frame_center = {2 * changes.shift->x * fitted.tan_half_width,
                         2 * changes.shift->y * fitted.tan_half_height};
  if (changes.lens) {
    made.lenses = nullptr;
    made.lens_radius = changes.lens->radius;
    made.focal_distance = changes.lens->focal_distance;
  }
  if (changes.aperture) {
    made.aperture_blades = changes.aperture->blades;
    made.aperture_turns = changes.aperture->turns;
  }
  if (changes.clip) {
    made.clip_near = changes.clip->near;
    made.clip_far = changes.clip->far;
    made.clips_by_distance = false;
  }
  return made;
}

}  // namespace twinray

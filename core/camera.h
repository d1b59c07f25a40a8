// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <limits>

#include "core/aabb.h"
#include "core/ray.h"
#include "core/vec.h"

namespace twinray {

/// A camera with a thin lens; with lens_radius 0 a pinhole, or, where it is orthographic, one whose rays are
/// parallel. The three axes are orthonormal.
struct Camera {
  Vec3 position{0, 0, 0};
  Vec3 right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};
  /// Half the frame, in units of the distance to it; of an orthographic camera in scene units.
  float tan_half_width = 0.5f, tan_half_height = 0.375f;
  float clip_near = 0;  ///< Depths along `forward`: nearer and farther things
  float clip_far = std::numeric_limits<float>::infinity();  ///< are not seen by camera rays.
  float lens_radius = 0;
  float focal_distance = 1;        ///< Depth of the plane in focus, > 0; it matters for lens_radius > 0 only.
  bool clips_by_distance = false;  ///< The clip distances count along each ray, and not along `forward`.
  bool is_orthographic = false;    ///< Parallel rays along `forward`, from the plane through the position.
  bool is_stretched = false;       ///< The frame fills a picture of any shape: its pixels may be oblong.
};

/// The camera widened on one axis, so that an image of this size has square pixels and shows the whole frame;
/// one that is stretched, as it is.
Camera fit_frame(const Camera& camera, int width, int height);

/// The camera without clip distances.
Camera without_clip(const Camera& camera);

/// The camera moved, without a turn and without clip distances, to where a box just fits into its frame (with
/// a margin of 4 %), in the middle. The frame of an orthographic camera is scaled so that it does. An empty
/// box leaves it where it is.
Camera view_whole(const Camera& camera, const Aabb& box);

/// The ray through a point of the frame, (0, 0) top left and (1, 1) bottom right, and a point of the lens in
/// the unit disc. Its direction has length 1 along `forward`, so t counts depth.
Ray camera_ray(const Camera& camera, Vec2 frame, Vec2 lens);

}  // namespace twinray

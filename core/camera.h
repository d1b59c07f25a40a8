// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <limits>
#include <memory>
#include <string>

#include "core/aabb.h"
#include "core/lens_system.h"
#include "core/ray.h"
#include "core/vec.h"

namespace twinray {

/// Which direction a point of the frame has. The last three are panoramas: all rays start at the position.
enum class Projection {
  perspective,         ///< The frame lies in a plane at distance 1.
  orthographic,        ///< Parallel rays along `forward`, from the plane through the position.
  latitude_longitude,  ///< Columns are angles about `up`, rows angles to it; `forward` is in the middle.
  fisheye,             ///< Equidistant: the angle to `forward` grows as the distance from the middle does.
  equal_area,          ///< All directions in a square, each pixel of the same solid angle, as pbrt-v4 has it.
};

/// A camera with a thin lens, with lens_radius 0 a pinhole, or with a lens as it is built. The three axes are
/// orthonormal.
struct Camera {
  Vec3 position{0, 0, 0};
  Vec3 right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};
  Projection projection = Projection::perspective;
  /// Half the frame, in units of the distance to it; in scene units where the rays are parallel; of a
  /// panorama in radians. A fisheye sees what lies within the smaller of the two. An equal-area square is
  /// always whole, and sqrt(pi) from its middle to a side.
  float tan_half_width = 0.5f, tan_half_height = 0.375f;
  Vec2 frame_center{0, 0};  ///< Of the frame, to the right and up, in the same units: a lens that is shifted.
  float clip_near = 0;      ///< Depths along `forward`: nearer and farther things
  float clip_far = std::numeric_limits<float>::infinity();  ///< are not seen by camera rays.
  float lens_radius = 0;                                    ///< Panoramas have none.
  float focal_distance = 1;  ///< Depth of the plane in focus, > 0; it matters for lens_radius > 0 only.
  int aperture_blades = 0;   ///< Corners of the lens, 3 or more, at the radius; 0: it is round.
  float aperture_turns = 0;  ///< How far the first corner is turned from `right` towards `up`, in [0, 1).
  /// Of a perspective camera without a thin lens: what its rays go through, the film around the position;
  /// null of most. The frame's plane is at its image_distance() behind the rear principal plane.
  std::shared_ptr<const LensSystem> lenses = nullptr;
  bool clips_by_distance = false;  ///< The clip distances count along each ray, as those of panoramas do.
  bool is_stretched = false;       ///< The frame fills a picture of any shape: its pixels may be oblong.
};

/// "perspective", "orthographic", "latitude-longitude", "fisheye", "equal-area".
std::string projection_name(Projection projection);

/// Whether rays start at points of a lens.
inline bool has_lens(const Camera& camera) { return camera.lens_radius != 0 || camera.lenses; }

/// Whether rays go from one point to many sides.
inline bool is_panorama(Projection projection) {
  return projection != Projection::perspective && projection != Projection::orthographic;
}

/// The camera widened on one axis, so that an image of this size has square pixels and shows the whole frame;
/// one that is stretched, as it is.
Camera fit_frame(const Camera& camera, int width, int height);
/// The same for any image of this width over height.
Camera fit_frame(const Camera& camera, float aspect);

/// The camera without clip distances.
Camera without_clip(const Camera& camera);

/// The camera moved, without a turn and without clip distances, to where a box just fits into its frame (with
/// a margin of 4 %), in the middle, with the frame around the axis of view. The frame of an orthographic
/// camera is scaled so that it does; a panorama is taken from the middle of the box. An empty box leaves it
/// where it is.
Camera view_whole(const Camera& camera, const Aabb& box);

/// The same eye with the frame of a panorama: all directions, or, of a fisheye, those within an angle of
/// `half_field` to the axis of view, in radians. It has no lens.
Camera with_panorama(const Camera& camera, Projection panorama, float half_field);

/// The ray through a point of the frame, (0, 0) top left and (1, 1) bottom right, and a point of the thin
/// lens in the unit disc. Its direction has length 1 along `forward`, so t counts depth; in a panorama it is
/// a unit vector, and t counts distance. Beside the frame goes on what is in it. A point without a direction,
/// outside of a fisheye's circle, has a ray whose interval is empty.
Ray camera_ray(const Camera& camera, Vec2 frame, Vec2 lens);

/// A camera ray, and how much of the light along it the lens lets through, over the density of the ray.
struct LensRay {
  Ray ray;
  float light = 1;
};
/// That through a random point of the lens; u uniform in [0, 1)^2. Where a lens system lets no light through,
/// the ray is that of a pinhole: it says what the pixel shows.
LensRay lens_ray(const Camera& camera, Vec2 frame, Vec2 u);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// What the command line changes of a scene's camera.
#pragma once
#include <optional>

#include "core/aabb.h"
#include "core/camera.h"

namespace twinray {

struct Lens {
  float radius = 0, focal_distance = 1;  ///< In scene units; the distance is > 0 where the radius is.
};

/// The shape of a lens.
struct Aperture {
  int blades = 0;
  float turns = 0;
};

/// Another way of seeing.
struct AskedProjection {
  Projection projection = Projection::perspective;
  /// Degrees from side to side of what is seen: of a perspective the frame's height, of a fisheye all; of an
  /// orthographic camera the frame's height in scene units. Not set: the usual one.
  std::optional<float> size;
};

struct ClipPlanes {
  float near = 0, far = 0;
};

struct CameraChanges {
  std::optional<AskedProjection> projection;
  std::optional<Lens> lens;
  std::optional<Aperture> aperture;
  std::optional<Vec2> shift;  ///< Of the frame to the right and up, as parts of its width and height.
  std::optional<ClipPlanes> clip;
};

/// The camera with another projection, for a picture of this shape. Without a size an orthographic frame is
/// what the camera saw around the middle of the box. Throws UsageError where that lies behind it.
Camera with_projection(const Camera& camera, const AskedProjection& asked, const Aabb& box, double aspect);

/// The camera with the other changes; `fitted` has the frame that the picture shows. Throws UsageError for a
/// lens or a shift of a panorama.
Camera changed(const Camera& camera, const CameraChanges& changes, const Camera& fitted);

}  // namespace twinray

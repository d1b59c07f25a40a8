// SPDX-License-Identifier: Apache-2.0
#include "io/default_camera.h"

#include "core/elementary.h"
#include "io/axis.h"

namespace twinray {

Camera default_camera(const Aabb& bounds) {
  constexpr double half_field = 0.3490658503988659;  // 20 degrees
  const Axis back = Axis{0.6, 0.5, 1}.unit();
  const Axis right = Axis{0, 1, 0}.cross(back).unit();
  Camera camera;
  camera.forward = Axis{-back.x, -back.y, -back.z}.vec();
  camera.right = right.vec();
  camera.up = back.cross(right).vec();
  camera.tan_half_width = camera.tan_half_height = float(tan_radians(half_field));
  camera.position = back.vec();
  return view_whole(camera, bounds);
}

}  // namespace twinray

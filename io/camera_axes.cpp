// SPDX-License-Identifier: Apache-2.0
#include "io/camera_axes.h"

#include <cmath>

#include "io/axis.h"

namespace twinray {
namespace {

Axis column(const Transform& t, int c) { return {t.m[0][c], t.m[1][c], t.m[2][c]}; }

CameraAxes without(const char* fault) { return {{}, {}, {}, false, fault}; }

}  // namespace

double frame_scale(const Transform& to_world, int axis) {
  const double length = column(to_world, axis).length();
  return length > 0 ? length : 1;
}

CameraAxes camera_axes(const Transform& to_world) {
  constexpr double flat = 1e-6;
  const Axis x = column(to_world, 0), y = column(to_world, 1), z = column(to_world, 2);
  if (!(z.length() > 0) || !std::isfinite(x.length() + y.length() + z.length()))
    return without("the transform of this camera's node gives it no direction: it flattens the z axis");
  const Axis back = z.unit();
  Axis up = y.minus(back, y.dot(back));
  const Axis right = x.minus(back, x.dot(back));
  const bool has_up = up.length() > flat * y.length(), has_right = right.length() > flat * x.length();
  if (!has_up && !has_right) return without("the transform of this camera's node leaves it no up direction");
  if (!has_up) up = back.cross(right);
  up = up.unit();
  const Axis across = up.cross(back);
  const double side = has_right && across.dot(right) < 0 ? -1 : 1;
  return {Axis{side * across.x, side * across.y, side * across.z}.vec(), up.vec(),
          Axis{-back.x, -back.y, -back.z}.vec(), !has_up, ""};
}

}  // namespace twinray

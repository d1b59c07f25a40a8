// SPDX-License-Identifier: Apache-2.0
#include "core/visible_pixels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/box_corners.h"

namespace twinray {
namespace {

/// What the corners of the box span on one axis of the picture, in pixels.
struct Span {
  double margin;
  double least = std::numeric_limits<double>::infinity(), most = -least;

  void extend(double x) {
    least = std::min(least, x);
    most = std::max(most, x);
  }
  int begin(int size) const { return int(std::floor(std::clamp(least - margin, 0.0, double(size)))); }
  int end(int size) const { return int(std::ceil(std::clamp(most + margin, 0.0, double(size)))); }
};

double along(const Vec3& axis, const Vec3& p, const Vec3& origin) {
  return double(axis.x) * (double(p.x) - origin.x) + double(axis.y) * (double(p.y) - origin.y) +
         double(axis.z) * (double(p.z) - origin.z);
}

}  // namespace

PixelRect visible_pixels(const Camera& camera, const Aabb& box, int width, int height, Vec2 margin) {
  if (box.is_empty()) return {0, 0, 0, 0};
  if (is_panorama(camera.projection)) return {0, 0, width, height};
  const bool is_parallel = camera.projection == Projection::orthographic;
  Span x{margin.x}, y{margin.y};
  for (const Vec3& corner : corners_of(box)) {
    const double scale = is_parallel ? 1 : along(camera.forward, corner, camera.position);
    if (camera.lens_radius != 0 || !(scale > 0)) return {0, 0, width, height};
    const double right = along(camera.right, corner, camera.position) / scale - camera.frame_center.x;
    const double up = along(camera.up, corner, camera.position) / scale - camera.frame_center.y;
    x.extend((1 + right / camera.tan_half_width) / 2 * width);
    y.extend((1 - up / camera.tan_half_height) / 2 * height);
  }
  return {x.begin(width), y.begin(height), x.end(width), y.end(height)};
}

}  // namespace twinray

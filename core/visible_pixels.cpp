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
  /// Within from..to.
  int begin(int from, int to) const {
    return int(std::floor(std::clamp(least - margin, double(from), double(to))));
  }
  int end(int from, int to) const {
    return int(std::ceil(std::clamp(most + margin, double(from), double(to))));
  }
};

double along(const Vec3& axis, const Vec3& p, const Vec3& origin) {
  return double(axis.x) * (double(p.x) - origin.x) + double(axis.y) * (double(p.y) - origin.y) +
         double(axis.z) * (double(p.z) - origin.z);
}

}  // namespace

PixelRect visible_pixels(const Camera& camera, const Aabb& box, const PicturePixels& pixels) {
  const auto& [width, height, window, margin] = pixels;
  if (box.is_empty()) return {0, 0, 0, 0};
  if (is_panorama(camera.projection)) return window;
  const bool is_parallel = camera.projection == Projection::orthographic;
  Span x{margin.x}, y{margin.y};
  for (const Vec3& corner : corners_of(box)) {
    const double scale = is_parallel ? 1 : along(camera.forward, corner, camera.position);
    if (has_lens(camera) || !(scale > 0)) return window;
    const double right = along(camera.right, corner, camera.position) / scale - camera.frame_center.x;
    const double up = along(camera.up, corner, camera.position) / scale - camera.frame_center.y;
    x.extend((1 + right / camera.tan_half_width) / 2 * width);
    y.extend((1 - up / camera.tan_half_height) / 2 * height);
  }
  return {x.begin(window.x0, window.x1), y.begin(window.y0, window.y1), x.end(window.x0, window.x1),
          y.end(window.y0, window.y1)};
}

}  // namespace twinray

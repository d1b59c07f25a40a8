// SPDX-License-Identifier: Apache-2.0
#include "io/picture/equal_area.h"

#include <cmath>

#include "core/direction_map.h"

namespace twinray {
namespace {

/// A row of w columns around has w / (2 pi) of them in a radian; a square of n^2 pixels in 4 pi steradians
/// has n / sqrt(4 pi).
constexpr double side_per_width = 0.56418958354775628;
constexpr int least_side = 64, parts = 4;

}  // namespace

Image equal_area_of(const Image& map, MapLayout layout) {
  const int side = std::max(least_side, int(std::ceil(map.width * side_per_width)));
  Image square(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      Rgb sum;
      for (int part = 0; part < parts * parts; ++part) {
        const MapPoint at{(x + (part % parts + 0.5) / parts) / side,
                          (y + (part / parts + 0.5) / parts) / side};
        sum += map_value(layout, map, map_point(layout, wrapped_direction(at)));
      }
      square.at(x, y) = sum / float(parts * parts);
    }
  return square;
}

Image hemisphere(const Rgb& radiance) {
  constexpr int side = 64;
  Image square(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      // Twice the distance to the middle, in pixels: the hemisphere ends where its sum is the side, along a
      // diagonal of pixels that are half within.
      const int distance = std::abs(2 * x + 1 - side) + std::abs(2 * y + 1 - side);
      square.at(x, y) = radiance * (distance < side ? 1.0f : distance == side ? 0.5f : 0.0f);
    }
  return square;
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/light_strength.h"

#include <cmath>

#include "core/angle.h"
#include "core/direction_map.h"

namespace twinray {
namespace {

/// The sum of `weigh(pixel, centre)` times the solid angle of each pixel.
template <typename Weigh>
double sum_by_solid_angle(const Image& map, MapLayout layout, const Weigh& weigh) {
  double sum = 0;
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const auto point = [&](double right, double down) {
        return MapPoint{(x + right) / map.width, (y + down) / map.height};
      };
      const MapCell cell{point(0, 0), point(1, 1)};
      sum += weigh(map.at(x, y), cell) * solid_angle(layout, cell);
    }
  return sum;
}

}  // namespace

double sphere_sum(const Image& map, MapLayout layout) {
  return sum_by_solid_angle(map, layout, [](const Rgb& pixel, const MapCell&) {
    return (double(pixel.r) + double(pixel.g) + double(pixel.b)) / 3;
  });
}

double frame_sum(const Image& picture, double half_width, double half_height) {
  double sum = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const double right = ((x + 0.5) / picture.width * 2 - 1) * half_width,
                   down = ((y + 0.5) / picture.height * 2 - 1) * half_height;
      const double cosine = 1 / std::sqrt(1 + right * right + down * down);
      sum += double(luminance(picture.at(x, y))) * cosine * cosine * cosine;
    }
  return sum * 4 * half_width * half_height / (double(picture.width) * double(picture.height));
}

double illuminance_sum(const Image& map, MapLayout layout, const Transform& to_light) {
  return sum_by_solid_angle(map, layout, [&](const Rgb& pixel, const MapCell& cell) {
    const float cosine = to_light.vector(direction_within(layout, cell, {0.5f, 0.5f})).z;
    return cosine > 0 ? double(luminance(pixel)) * double(cosine) / 2 : 0;
  });
}

}  // namespace twinray

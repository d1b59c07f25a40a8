// SPDX-License-Identifier: Apache-2.0
#include "core/direction_map.h"

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "core/elementary.h"

namespace twinray {
namespace {

double lerp(double from, double to, double t) { return from + (to - from) * t; }

/// The cosine of the angle to +y at a height of a latitude-longitude map.
double latitude_cosine(double y) { return cos_radians(pi_double * y); }

MapPoint latitude_longitude_point(const Vec3& d) {
  const double horizontal = std::sqrt(double(d.x) * d.x + double(d.z) * d.z);
  const double around = atan2_turns(-d.z, d.x) + 0.5;
  return {around < 1 ? around : around - 1, 2 * atan2_turns(horizontal, d.y)};
}

Vec3 latitude_longitude_direction(double x, double cosine) {
  const double r = std::sqrt(std::max(0.0, (1 - cosine) * (1 + cosine)));
  const SinCos angle = sincos_turns(float(x < 0.5 ? x + 0.5 : x - 0.5));
  return {float(r * angle.cos), float(cosine), float(-r * angle.sin)};
}

/// Clarberg, "Fast Equal-Area Mapping of the (Hemi)Sphere using SIMD", 2008: a square around +z, whose
/// corners all are -z. r is 1 on the horizon, and r^2 is 1 - |z|.
MapPoint equal_area_point(const Vec3& d) {
  const double squared = double(d.x) * d.x + double(d.y) * d.y;
  const double length = std::sqrt(squared + double(d.z) * d.z);
  const double r = std::sqrt(squared / (length * (length + std::fabs(double(d.z)))));
  const double quarter = 4 * atan2_turns(std::fabs(d.y), std::fabs(d.x));
  double u = r - quarter * r, v = quarter * r;
  if (std::signbit(d.z)) {
    const double mirrored = 1 - v;
    v = 1 - u;
    u = mirrored;
  }
  return {0.5 + 0.5 * std::copysign(u, d.x), 0.5 + 0.5 * std::copysign(v, d.y)};
}

Vec3 equal_area_direction(MapPoint p) {
  const double x = 2 * p.x - 1, y = 2 * p.y - 1;
  const double u = std::fabs(x), v = std::fabs(y);
  const double above = 1 - (u + v);  // Negative below the horizon.
  const double r = 1 - std::fabs(above);
  const SinCos angle = sincos_turns(r == 0 ? 0.0f : float(((v - u) / r + 1) * 0.125));
  const double horizontal = r * std::sqrt(2 - r * r);
  return {float(std::copysign(horizontal * angle.cos, x)), float(std::copysign(horizontal * angle.sin, y)),
          float(std::copysign(1 - r * r, above))};
}

}  // namespace

MapPoint map_point(MapLayout layout, const Vec3& direction) {
  return layout == MapLayout::equal_area ? equal_area_point(direction) : latitude_longitude_point(direction);
}

Vec3 wrapped_direction(MapPoint point) {
  auto [x, y] = point;
  // Each edge of the square is folded in its middle, and continues itself.
  if (x < 0 || x > 1) x = x < 0 ? -x : 2 - x, y = 1 - y;
  if (y < 0 || y > 1) y = y < 0 ? -y : 2 - y, x = 1 - x;
  return equal_area_direction({std::clamp(x, 0.0, 1.0), std::clamp(y, 0.0, 1.0)});
}

double map_height(MapLayout layout, double y) {
  return layout == MapLayout::equal_area ? y : latitude_cosine(y);
}

Vec3 direction_within(MapLayout layout, const MapCell& cell, Vec2 u) {
  return direction_between(
      layout,
      {{cell.lower.x, map_height(layout, cell.lower.y)}, {cell.upper.x, map_height(layout, cell.upper.y)}},
      u);
}

Vec3 direction_between(MapLayout layout, const MapCell& heights, Vec2 u) {
  const double x = lerp(heights.lower.x, heights.upper.x, u.x);
  const double height = lerp(heights.lower.y, heights.upper.y, u.y);
  return layout == MapLayout::equal_area ? equal_area_direction({x, height})
                                         : latitude_longitude_direction(x, height);
}

double solid_angle(MapLayout layout, const MapCell& cell) {
  const double width = cell.upper.x - cell.lower.x;
  if (layout == MapLayout::equal_area) return 4 * pi_double * width * (cell.upper.y - cell.lower.y);
  return 2 * pi_double * width * (latitude_cosine(cell.lower.y) - latitude_cosine(cell.upper.y));
}

const Rgb& wrapped_pixel(MapLayout layout, const Image& map, int x, int y) {
  const int w = map.width, h = map.height;
  if (layout == MapLayout::latitude_longitude)
    return map.at(x < 0 ? x + w : x >= w ? x - w : x, std::clamp(y, 0, h - 1));
  // Each edge of the square is folded in its middle, and continues itself.
  if (x < 0 || x >= w) {
    x = x < 0 ? -1 - x : 2 * w - 1 - x;
    y = h - 1 - y;
  }
  if (y < 0 || y >= h) {
    y = y < 0 ? -1 - y : 2 * h - 1 - y;
    x = w - 1 - x;
  }
  return map.at(x, y);
}

namespace {

/// Bilinear between the centres of the pixels; beside(x, y) gives those up to one beside the picture.
template <typename Pixel>
Rgb bilinear(const Image& picture, MapPoint point, const Pixel& beside) {
  const double column = point.x * picture.width - 0.5, row = point.y * picture.height - 0.5;
  const double left = std::floor(column), above = std::floor(row);
  const auto s = float(column - left), t = float(row - above);
  const int x = int(left), y = int(above);
  const auto between = [&](const auto& pixel) {
    const Rgb upper = pixel(x, y) * (1 - s) + pixel(x + 1, y) * s;
    const Rgb lower = pixel(x, y + 1) * (1 - s) + pixel(x + 1, y + 1) * s;
    return upper * (1 - t) + lower * t;
  };
  const bool is_within = x >= 0 && y >= 0 && x + 1 < picture.width && y + 1 < picture.height;
  return is_within ? between([&](int i, int j) -> const Rgb& { return picture.at(i, j); }) : between(beside);
}

}  // namespace

Rgb clamped_value(const Image& picture, MapPoint point) {
  return bilinear(picture, point, [&](int x, int y) -> const Rgb& {
    return picture.at(std::clamp(x, 0, picture.width - 1), std::clamp(y, 0, picture.height - 1));
  });
}

Rgb map_value(MapLayout layout, const Image& map, MapPoint point) {
  return bilinear(map, point, [&](int x, int y) -> const Rgb& { return wrapped_pixel(layout, map, x, y); });
}

}  // namespace twinray

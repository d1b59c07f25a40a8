// SPDX-License-Identifier: Apache-2.0
#include "core/pixel_filter.h"

#include <fmt/format.h>

#include <cmath>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/error.h"

namespace twinray {
namespace {

constexpr double log2_e = 1.4426950408889634;
constexpr float sigmas_per_radius = 3;

struct KindInfo {
  const char* name;
  float radius;
};
constexpr KindInfo kinds[] = {
    {"box", 0.5f}, {"triangle", 1}, {"gaussian", 1.5f}, {"blackman-harris", 1.5f}, {"mitchell", 2}};

double bell(double x, double sigma) { return exp2_of(-x * x / (2 * sigma * sigma) * log2_e); }

/// x in [0, 1].
double blackman_harris(double x) {
  const double angle = pi_double * x;
  return 0.35875 + 0.48829 * cos_radians(angle) + 0.14128 * cos_radians(2 * angle) +
         0.01168 * cos_radians(3 * angle);
}

/// x in [0, 2].
double mitchell(double x, double b, double c) {
  if (x < 1) return ((12 - 9 * b - 6 * c) * x * x * x + (-18 + 12 * b + 6 * c) * x * x + (6 - 2 * b)) / 6;
  return ((-b - 6 * c) * x * x * x + (6 * b + 30 * c) * x * x + (-12 * b - 48 * c) * x + (8 * b + 24 * c)) /
         6;
}

void check_range(const char* what, float value, float least, float most) {
  if (!(value >= least && value <= most))
    throw Error(fmt::format("a pixel filter's {} is {}; valid are {} to {}", what, value, least, most));
}

}  // namespace

void check(const PixelFilter& filter) {
  check_range("radius", filter.radius.x, least_filter_radius, most_filter_radius);
  check_range("radius", filter.radius.y, least_filter_radius, most_filter_radius);
  if (filter.kind == FilterKind::gaussian) check_range("sigma", filter.sigma, 1e-2f, 1e3f);
  if (filter.kind == FilterKind::mitchell) {
    check_range("B", filter.b, 0, 1);
    check_range("C", filter.c, 0, 1);
  }
}

std::string filter_name(FilterKind kind) { return kinds[std::size_t(kind)].name; }

PixelFilter usual_filter(FilterKind kind) { return filter_of_radius(kind, kinds[std::size_t(kind)].radius); }

PixelFilter filter_of_radius(FilterKind kind, float radius) {
  PixelFilter filter{.kind = kind, .radius = {radius, radius}};
  if (kind == FilterKind::gaussian) filter.sigma = radius / sigmas_per_radius;
  return filter;
}

std::string filter_text(const PixelFilter& filter) {
  const auto& [x, y] = filter.radius;
  return fmt::format("{}:{}", filter_name(filter.kind),
                     x == y ? fmt::format("{}", x) : fmt::format("{}x{}", x, y));
}

double filter_value(const PixelFilter& filter, double radius, double x) {
  const double distance = std::fabs(x);
  if (distance > radius) return 0;
  switch (filter.kind) {
    case FilterKind::box:
      return 1;
    case FilterKind::triangle:
      return 1 - distance / radius;
    case FilterKind::gaussian:
      return bell(distance, double(filter.sigma)) - bell(radius, double(filter.sigma));
    case FilterKind::blackman_harris:
      return blackman_harris(distance / radius);
    case FilterKind::mitchell:
      return mitchell(2 * distance / radius, double(filter.b), double(filter.c));
  }
  return 0;
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "check/flip.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "check/flip_color.h"
#include "check/flip_filters.h"
#include "core/elementary.h"
#include "core/parallel.h"
#include "core/same_size.h"

namespace twinray {
namespace {

using flip::HuntLab;
using flip::Opponent;

constexpr std::size_t pixels_a_task = 1 << 13;

template <class Body>
void for_each_pixel(std::size_t count, const Body& body) {
  parallel_for(count, pixels_a_task, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) body(i);
  });
}

/// What is compared of a picture.
struct Seen {
  std::vector<HuntLab> colors;
  Plane edges, points;  ///< How strong they are.
};

struct OpponentPlanes {
  Plane y, cx, cz;
};

/// `displayed(pixel)` is what a display shows of it: a linear colour.
template <class Displayed>
OpponentPlanes opponent_planes(const Image& image, const Displayed& displayed) {
  const Plane empty(image.width, image.height);
  OpponentPlanes planes{empty, empty, empty};
  for_each_pixel(image.pixels.size(), [&](std::size_t i) {
    const Opponent color = flip::opponent_of(displayed(image.pixels[i]));
    planes.y.values[i] = color.y;
    planes.cx.values[i] = color.cx;
    planes.cz.values[i] = color.cz;
  });
  return planes;
}

std::vector<HuntLab> seen_colors(const OpponentPlanes& planes, double pixels_per_degree) {
  const Plane y = flip::blurred_brightness(planes.y, pixels_per_degree);
  const Plane cx = flip::blurred_red_green(planes.cx, pixels_per_degree);
  const Plane cz = flip::blurred_yellow_blue(planes.cz, pixels_per_degree);
  std::vector<HuntLab> colors(y.values.size());
  for_each_pixel(colors.size(), [&](std::size_t i) {
    colors[i] = flip::hunt_lab_of(flip::clipped(flip::linear_of({y.values[i], cx.values[i], cz.values[i]})));
  });
  return colors;
}

template <class Displayed>
Seen seen(const Image& image, double pixels_per_degree, const Displayed& displayed) {
  OpponentPlanes planes = opponent_planes(image, displayed);
  std::vector<HuntLab> colors = seen_colors(planes, pixels_per_degree);
  for (float& y : planes.y.values) y = (y + 16) / 116;
  return {std::move(colors), flip::edge_strength(planes.y, pixels_per_degree),
          flip::point_strength(planes.y, pixels_per_degree)};
}

double color_power(double distance) { return pow_of(distance, 0.7); }

/// Of the two most different colours of a display, green and blue.
double largest_color_power() {
  return color_power(flip::distance(flip::hunt_lab_of({0, 1, 0}), flip::hunt_lab_of({0, 0, 1})));
}

/// Differences up to 0.4 of the largest fill [0, 0.95], the few beyond the rest.
double color_difference(const HuntLab& a, const HuntLab& b, double largest) {
  constexpr double part = 0.4, value = 0.95;
  const double power = color_power(flip::distance(a, b)), bend = part * largest;
  return power < bend ? value * power / bend : value + (1 - value) * (power - bend) / (largest - bend);
}

double feature_difference(const Seen& a, const Seen& b, std::size_t i) {
  const float edges = std::abs(a.edges.values[i] - b.edges.values[i]);
  const float points = std::abs(a.points.values[i] - b.points.values[i]);
  return std::sqrt(std::max(edges, points) / std::numbers::sqrt2);
}

/// `map` becomes the larger of itself and what is seen as different.
template <class Displayed>
void add_differences(const Image& picture, const Image& reference, double pixels_per_degree,
                     const Displayed& displayed, FlipMap& map) {
  const Seen a = seen(picture, pixels_per_degree, displayed);
  const Seen b = seen(reference, pixels_per_degree, displayed);
  const double largest = largest_color_power();
  for_each_pixel(map.values.size(), [&](std::size_t i) {
    const double color = color_difference(a.colors[i], b.colors[i], largest);
    const double error = pow_of(color, 1 - feature_difference(a, b, i));
    map.values[i] = std::max(map.values[i], float(error));
  });
}

Rgb without_negatives(const Rgb& c) {
  return {std::max(c.r, 0.0f), std::max(c.g, 0.0f), std::max(c.b, 0.0f)};
}

/// Of an even number of values the upper one.
double median(std::vector<float> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

double mean_of(const FlipMap& map) {
  double sum = 0;
  for (const float value : map.values) sum += value;
  return sum / double(map.values.size());
}

FlipMap ldr_flip(const Image& picture, const Image& reference, double pixels_per_degree) {
  check_same_size(picture, reference);
  FlipMap map(reference.width, reference.height);
  add_differences(picture, reference, pixels_per_degree, flip::clipped, map);
  return map;
}

FlipExposures flip_exposures(const Image& reference) {
  constexpr double least = std::numeric_limits<float>::epsilon();
  std::vector<float> luminances;
  for (const Rgb& pixel : reference.pixels) luminances.push_back(luminance(without_negatives(pixel)));
  const double most = *std::max_element(luminances.begin(), luminances.end());
  if (!(most > 0)) return {};
  const double bright = log2_of(flip::radiance_of_bright_tone());
  const double first = bright - log2_of(most);
  const double last = bright - log2_of(std::min(most, std::max(least, median(std::move(luminances)))));
  return {first, last, int(std::max(2.0, std::ceil(last - first)))};
}

FlipMap hdr_flip(const Image& picture, const Image& reference, double pixels_per_degree) {
  check_same_size(picture, reference);
  FlipMap map(reference.width, reference.height);
  const FlipExposures exposures = flip_exposures(reference);
  for (int i = 0; i < exposures.count; ++i) {
    const double step = double(i) / std::max(1, exposures.count - 1);
    const auto factor = float(exp2_of(exposures.first + step * (exposures.last - exposures.first)));
    add_differences(
        picture, reference, pixels_per_degree,
        [&](const Rgb& c) { return flip::tone_mapped(factor * without_negatives(c)); }, map);
  }
  return map;
}

}  // namespace twinray

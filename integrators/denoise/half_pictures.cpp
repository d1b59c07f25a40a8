// SPDX-License-Identifier: Apache-2.0
#include "integrators/denoise/half_pictures.h"

#include <cmath>

#include "core/image_error.h"
#include "core/rgb.h"
#include "integrators/denoise/box_mean.h"

namespace twinray {
namespace {

constexpr float Rgb::*channels[] = {&Rgb::r, &Rgb::g, &Rgb::b};

/// A pixel's error is divided by what is around it, over squares of this radius, twice: a pixel that is too
/// bright by chance would hide its own error.
constexpr int level_radius = 2;

HalfPicture empty_half(const Film& film) {
  const Plane empty(film.window().width(), film.window().height());
  HalfPicture half{{empty, empty, empty}, {}};
  for (const Layer layer : film.layers())
    half.features.resize(half.features.size() + channel_count(layer), empty);
  return half;
}

void read_features(const Film& film, int x, int y, std::size_t at, HalfPicture& half) {
  std::size_t feature = 0;
  for (std::size_t layer = 0; layer < film.layers().size(); ++layer) {
    const Rgb value = film.value(layer, x, y);
    for (std::size_t c = 0; c < channel_count(film.layers()[layer]); ++c)
      half.features[feature++].values[at] = value.*channels[c];
  }
}

void take_color(const Rgb& value, std::size_t at, HalfPicture& half) {
  for (std::size_t c = 0; c < 3; ++c) half.color[c].values[at] = value.*channels[c];
}

void read_pixel(const Film& film, int x, int y, std::size_t at, HalfPicture& half) {
  take_color(film.pixel(x, y).mean(), at, half);
  read_features(film, x, y, at, half);
}

/// Calls `read(a, b, x, y, at)` for each pixel with the film of each half, or that of the other one where it
/// has no samples there.
template <typename Read>
void for_each_pixel(const HalfFilms& films, const Read& read) {
  const auto& [first, second] = films;
  const PixelRect& window = first.window();
  std::size_t at = 0;
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x, ++at)
      read(first.pixel(x, y).count > 0 ? first : second, second.pixel(x, y).count > 0 ? second : first, x, y,
           at);
}

}  // namespace

HalfPictures half_pictures(const HalfFilms& films) {
  const PixelRect& window = films.first.window();
  const int width = window.width(), height = window.height();
  HalfPictures made{width, height, {empty_half(films.first), empty_half(films.second)}, Plane(width, height)};
  for_each_pixel(films, [&](const Film& a, const Film& b, int x, int y, std::size_t at) {
    read_pixel(a, x, y, at, made.halves[0]);
    read_pixel(b, x, y, at, made.halves[1]);
    const double first = films.first.pixel(x, y).count, second = films.second.pixel(x, y).count;
    made.second_weight.values[at] = first + second == 0 ? 0 : float(second / (first + second));
  });
  return made;
}

void take_light_group(const HalfFilms& films, std::size_t group, HalfPictures& pictures) {
  std::vector<Rgb> parts(films.first.contents().parts[std::size_t(Division::groups)]);
  for_each_pixel(films, [&](const Film& a, const Film& b, int x, int y, std::size_t at) {
    a.read_parts(Division::groups, x, y, parts);
    take_color(parts[group], at, pictures.halves[0]);
    b.read_parts(Division::groups, x, y, parts);
    take_color(parts[group], at, pictures.halves[1]);
  });
}

Plane mean_of_halves(const Plane& a, const Plane& b, const Plane& second_weight) {
  Plane mean(a.width, a.height);
  for (std::size_t i = 0; i < mean.values.size(); ++i) {
    const float weight = second_weight.values[i];
    mean.values[i] = (1 - weight) * a.values[i] + weight * b.values[i];
  }
  return mean;
}

std::vector<Plane> means_of_halves(std::span<const Plane> a, std::span<const Plane> b,
                                   const Plane& second_weight) {
  std::vector<Plane> means;
  for (std::size_t i = 0; i < a.size(); ++i) means.push_back(mean_of_halves(a[i], b[i], second_weight));
  return means;
}

Plane half_variance(const Plane& a, const Plane& b, const Plane& second_weight) {
  Plane variance(a.width, a.height);
  for (std::size_t i = 0; i < variance.values.size(); ++i) {
    const float difference = a.values[i] - b.values[i], weight = second_weight.values[i];
    variance.values[i] = difference * difference * (weight * (1 - weight));
  }
  return variance;
}

double estimated_relative_error(const HalfPictures& pictures) {
  double sum = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const Plane &a = pictures.halves[0].color[c], &b = pictures.halves[1].color[c];
    const Plane mean = mean_of_halves(a, b, pictures.second_weight);
    const Plane level = box_mean(box_mean(mean, level_radius), level_radius);
    const Plane variance = half_variance(a, b, pictures.second_weight);
    for (std::size_t i = 0; i < mean.values.size(); ++i)
      sum += double(variance.values[i]) / (double(level.values[i]) * level.values[i] + least_relative_square);
  }
  return std::sqrt(sum / (3.0 * double(pictures.second_weight.values.size())));
}

}  // namespace twinray

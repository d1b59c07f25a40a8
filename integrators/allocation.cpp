// SPDX-License-Identifier: Apache-2.0
#include "integrators/allocation.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace twinray {
namespace {

/// A pixel's error is the mean of that of the pixels of the other colour which are so close, in either
/// direction: 24 within the picture. One alone says little of 16 samples.
constexpr int reach = 3;
/// Errors count by the brightness of their surroundings, as the eye has it: dark pixels by this part of the
/// mean at least.
constexpr double least_level = 1.0 / 16;
/// The part of the samples after the pilot that all pixels have alike: chance may have made an error small.
constexpr double even_part = 1.0 / 8;
/// The largest error that counts, in means of all: few pixels must not take everything.
constexpr double most_error = 16;

/// Of the two colours of a chessboard.
std::size_t color_of(int x, int y) { return std::size_t(x + y) & 1; }

/// What a pixel shows after the pilot.
struct PilotPixel {
  double level = 0;  ///< Brightness.
  double error = 0;  ///< Mean square, of the mean of all samples.
};

PilotPixel pilot_pixel(const Rgb& half, const Rgb& whole) {
  // The mean of both halves is as far from either.
  const double r = double(whole.r) - half.r, g = double(whole.g) - half.g, b = double(whole.b) - half.b;
  return {std::max(0.0, double(luminance(whole))), (r * r + g * g + b * b) / 3};
}

/// A pilot's pixels, row by row.
struct PilotPicture {
  int width, height;
  std::vector<PilotPixel> pixels;

  std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(width) + std::size_t(x); }
  const PilotPixel& at(int x, int y) const { return pixels[index(x, y)]; }
};

/// Calls f(x, y) for all pixels.
template <typename F>
void for_each_pixel(const PilotPicture& picture, const F& f) {
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) f(x, y);
}

/// The means over the pixels of each colour, where there are any.
template <typename Value>
std::array<double, 2> means_by_color(const PilotPicture& picture, const Value& value) {
  std::array<double, 2> sums{}, counts{};
  for_each_pixel(picture, [&](int x, int y) {
    sums[color_of(x, y)] += value(x, y);
    ++counts[color_of(x, y)];
  });
  for (std::size_t color = 0; color < 2; ++color) sums[color] /= std::max(1.0, counts[color]);
  return sums;
}

/// The root of the mean error around a pixel, over the brightness: by pixels of the other colour alone.
float error_around(const PilotPicture& picture, int x, int y, double least) {
  double sum = 0;
  int count = 0;
  for (int y1 = std::max(0, y - reach); y1 <= std::min(picture.height - 1, y + reach); ++y1)
    for (int x1 = std::max(0, x - reach); x1 <= std::min(picture.width - 1, x + reach); ++x1) {
      if (color_of(x1, y1) == color_of(x, y)) continue;
      const PilotPixel& pixel = picture.at(x1, y1);
      if (pixel.error > 0) sum += pixel.error / (pixel.level + least);
      ++count;
    }
  return count == 0 ? 0 : float(std::sqrt(sum / count));
}

}  // namespace

std::vector<Rgb> pixel_means(const Film& film) {
  const PixelRect& window = film.window();
  std::vector<Rgb> means;
  means.reserve(std::size_t(window.width()) * std::size_t(window.height()));
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x) means.push_back(film.pixel(x, y).mean());
  return means;
}

SampleAllocation::SampleAllocation(const PixelRect& window, std::span<const Rgb> half,
                                   std::span<const Rgb> whole)
    : window_(window), rates_(whole.size()) {
  PilotPicture picture{window.width(), window.height(), {}};
  picture.pixels.reserve(whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) picture.pixels.push_back(pilot_pixel(half[i], whole[i]));

  const auto levels = means_by_color(picture, [&](int x, int y) { return picture.at(x, y).level; });
  for_each_pixel(picture, [&](int x, int y) {
    rates_[picture.index(x, y)] = error_around(picture, x, y, least_level * levels[1 - color_of(x, y)]);
  });
  const auto means = means_by_color(picture, [&](int x, int y) { return rates_[picture.index(x, y)]; });
  for_each_pixel(picture, [&](int x, int y) {
    float& rate = rates_[picture.index(x, y)];
    const double mean = means[color_of(x, y)];
    rate = mean > 0 ? float(even_part + (1 - even_part) * std::min(most_error, rate / mean)) : 1;
  });
}

std::uint32_t SampleAllocation::samples_of(int x, int y, std::uint32_t n) const {
  if (n <= pilot) return n;
  const std::size_t at =
      std::size_t(y - window_.y0) * std::size_t(window_.width()) + std::size_t(x - window_.x0);
  const double samples = pilot + double(n - pilot) * rates_[at];
  return std::uint32_t(std::min(double(Film::max_samples), std::nearbyint(samples)));
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "core/film.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"

namespace twinray {
namespace {

/// In double, so that the variance of a constant pixel is 0 up to a double's rounding.
double wide_luminance(double r, double g, double b) { return 0.2126 * r + 0.7152 * g + 0.0722 * b; }

bool in_range(float x) { return std::fabs(x) <= Film::max_value; }  // A NaN is not.

}  // namespace

void FixedSum::add(double x) {
  assert(std::fabs(x) < 0x1p45);
  // Whole units of 2^-12, and what is left of x in units of 2^-60: nothing is rounded but the last cast.
  const double scaled = x * 0x1p12;
  const std::int64_t upper = std::int64_t(scaled);
  const std::int64_t lower = std::int64_t((scaled - double(upper)) * 0x1p48);
  units_ += (__extension__ __int128(upper) << 48) + lower;
}

FixedSum& FixedSum::operator+=(const FixedSum& other) {
  units_ += other.units_;
  return *this;
}

double FixedSum::value() const { return double(units_) * 0x1p-60; }

Rgb PixelSums::mean() const {
  if (count == 0) return {};
  return {float(r.value() / count), float(g.value() / count), float(b.value() / count)};
}

double PixelSums::luminance_mean() const {
  return count == 0 ? 0 : wide_luminance(r.value(), g.value(), b.value()) / count;
}

double PixelSums::luminance_variance() const {
  if (count < 2) return 0;
  const double sum = wide_luminance(r.value(), g.value(), b.value());
  return std::max(0.0, (luminance_squared.value() - sum * (sum / count)) / (count - 1));
}

PixelSums& PixelSums::operator+=(const PixelSums& other) {
  r += other.r;
  g += other.g;
  b += other.b;
  luminance_squared += other.luminance_squared;
  count += other.count;
  return *this;
}

Film::Film(int frame_width, int frame_height, PixelRect window, std::vector<std::string> layers)
    : frame_width_(frame_width), frame_height_(frame_height), window_(window), layers_(std::move(layers)) {
  constexpr int largest = 65536;
  if (frame_width < 1 || frame_width > largest || frame_height < 1 || frame_height > largest)
    throw Error(fmt::format("a frame of {} x {} pixels: each side must lie in 1 to {}", frame_width,
                            frame_height, largest));
  const bool within =
      window.x0 >= 0 && window.y0 >= 0 && window.x1 <= frame_width && window.y1 <= frame_height;
  if (!within || window.x0 >= window.x1 || window.y0 >= window.y1)
    throw Error(
        fmt::format("the window x {} to {}, y {} to {} is empty or not within the frame of {} x {} pixels",
                    window.x0, window.x1, window.y0, window.y1, frame_width, frame_height));
  if (layers_.empty()) throw Error("a film without layers");
  const std::size_t count = std::size_t(window.width()) * std::size_t(window.height());
  pixels_.resize(count * layers_.size());
  rejected_.resize(count);
  rejected_index_.resize(count);
}

std::size_t Film::offset(std::size_t layer, int x, int y) const {
  assert(layer < layers_.size());
  assert(x >= window_.x0 && x < window_.x1 && y >= window_.y0 && y < window_.y1);
  const std::size_t width = std::size_t(window_.width()), height = std::size_t(window_.height());
  return (layer * height + std::size_t(y - window_.y0)) * width + std::size_t(x - window_.x0);
}

bool Film::add(std::size_t layer, int x, int y, std::uint32_t sample_index, const Rgb& value) {
  if (!in_range(value.r) || !in_range(value.g) || !in_range(value.b)) {
    const std::size_t place = offset(0, x, y);
    std::uint32_t& least = rejected_index_[place];
    least = rejected_[place] == 0 ? sample_index : std::min(least, sample_index);
    ++rejected_[place];
    return false;
  }
  PixelSums& sums = pixels_[offset(layer, x, y)];
  assert(sums.count < max_samples);
  sums.r.add(value.r);
  sums.g.add(value.g);
  sums.b.add(value.b);
  const double luminance = wide_luminance(value.r, value.g, value.b);
  sums.luminance_squared.add(luminance * luminance);
  ++sums.count;
  return true;
}

const PixelSums& Film::pixel(std::size_t layer, int x, int y) const { return pixels_[offset(layer, x, y)]; }

std::uint64_t Film::rejected_count() const {
  std::uint64_t sum = 0;
  for (const std::uint32_t count : rejected_) sum += count;
  return sum;
}

std::uint32_t Film::rejected_count(int x, int y) const { return rejected_[offset(0, x, y)]; }

RejectedSample Film::first_rejected() const {
  const auto first = std::find_if(rejected_.begin(), rejected_.end(), [](auto count) { return count > 0; });
  if (first == rejected_.end()) return {};
  const int place = int(first - rejected_.begin());
  return {.x = window_.x0 + place % window_.width(),
          .y = window_.y0 + place / window_.width(),
          .index = rejected_index_[std::size_t(place)]};
}

void Film::check_mergeable(const Film& other) const {
  if (other.frame_width_ != frame_width_ || other.frame_height_ != frame_height_)
    throw Error(fmt::format("films of different frames cannot be merged: {} x {} and {} x {} pixels",
                            frame_width_, frame_height_, other.frame_width_, other.frame_height_));
  if (other.layers_ != layers_)
    throw Error(fmt::format("films of different layers cannot be merged: {} and {}", fmt::join(layers_, ", "),
                            fmt::join(other.layers_, ", ")));
  const PixelRect& a = window_;
  const PixelRect& b = other.window_;
  if (b.x0 < a.x0 || b.y0 < a.y0 || b.x1 > a.x1 || b.y1 > a.y1)
    throw Error(fmt::format(
        "the window x {} to {}, y {} to {} cannot be merged into the smaller x {} to {}, y {} to {}", b.x0,
        b.x1, b.y0, b.y1, a.x0, a.x1, a.y0, a.y1));
}

void Film::merge(const Film& other) {
  check_mergeable(other);
  other.for_each_sum([&](std::size_t layer, int x, int y, const PixelSums& sums) {
    if (pixel(layer, x, y).count + sums.count > max_samples)
      throw Error(fmt::format("merged, pixel ({}, {}) has more than {} samples", x, y, max_samples));
  });
  other.for_each_sum([&](std::size_t layer, int x, int y, const PixelSums& sums) {
    pixels_[offset(layer, x, y)] += sums;
    const std::size_t from = other.offset(0, x, y), to = offset(0, x, y);
    if (layer > 0 || other.rejected_[from] == 0) return;
    const std::uint32_t index = other.rejected_index_[from];
    rejected_index_[to] = rejected_[to] == 0 ? index : std::min(rejected_index_[to], index);
    rejected_[to] += other.rejected_[from];
  });
}

}  // namespace twinray

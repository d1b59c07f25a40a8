// SPDX-License-Identifier: Apache-2.0
#include "core/film.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/error.h"

namespace twinray {
namespace {

/// In double, so that the variance of a constant pixel is 0 up to a double's rounding.
double wide_luminance(double r, double g, double b) { return 0.2126 * r + 0.7152 * g + 0.0722 * b; }

__extension__ using Int128 = __int128;
__extension__ using Unsigned128 = unsigned __int128;

bool in_range(float x) { return std::fabs(x) <= Film::max_value; }  // A NaN is not.

using Words = std::array<std::uint32_t, 3>;

Int128 units_of(const Words& words) {
  return Int128(std::int32_t(words[2])) * (Int128(1) << 64) + (std::uint64_t(words[1]) << 32 | words[0]);
}

Words words_of(Int128 units) {
  return {std::uint32_t(units), std::uint32_t(units >> 32), std::uint32_t(units >> 64)};
}

}  // namespace

void FixedSum::add(double x) {
  assert(std::fabs(x) <= Film::max_value);
  constexpr double one_word = 0x1p19;
  if (std::fabs(x) < one_word) {
    words_ = words_of(units_of(words_) + std::llrint(x * 0x1p43));
    return;
  }
  // Whole units of 2^-11, and what is left of x in units of 2^-43: nothing is rounded but the last one.
  const double scaled = x * 0x1p11;
  const double upper = std::trunc(scaled);
  const Int128 units = (Int128(std::int64_t(upper)) << 32) + std::llrint((scaled - upper) * 0x1p32);
  words_ = words_of(units_of(words_) + units);
}

FixedSum& FixedSum::operator+=(const FixedSum& other) {
  words_ = words_of(units_of(words_) + units_of(other.words_));
  return *this;
}

double FixedSum::value() const { return double(units_of(words_)) * 0x1p-43; }

void FixedSquareSum::add_square_of(double x) {
  const double square = x * x;
  assert(square < 0x1.0001p60);
  constexpr double one_word = 0x1p16;
  if (square < one_word) {
    const double scaled = square * 0x1p46;
    const auto whole = std::int64_t(scaled);
    units_ += std::uint64_t(whole + (double(whole) < scaled));
    return;
  }
  const double upper = std::trunc(square);
  const auto lower = std::uint64_t(std::ceil((square - upper) * 0x1p46));
  units_ += (Unsigned128(std::uint64_t(upper)) << 46) + lower;
}

FixedSquareSum& FixedSquareSum::operator+=(const FixedSquareSum& other) {
  units_ += other.units_;
  return *this;
}

double FixedSquareSum::value() const { return double(units_) * 0x1p-46; }

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
  if (other.rejected > 0)
    rejected_index = rejected == 0 ? other.rejected_index : std::min(rejected_index, other.rejected_index);
  rejected += other.rejected;
  return *this;
}

void PixelSums::reject(std::uint32_t sample_index) {
  rejected_index = rejected == 0 ? sample_index : std::min(rejected_index, sample_index);
  ++rejected;
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
}

std::size_t Film::offset(std::size_t layer, int x, int y) const {
  assert(layer < layers_.size());
  assert(x >= window_.x0 && x < window_.x1 && y >= window_.y0 && y < window_.y1);
  const std::size_t width = std::size_t(window_.width()), height = std::size_t(window_.height());
  return (layer * height + std::size_t(y - window_.y0)) * width + std::size_t(x - window_.x0);
}

bool Film::add(std::size_t layer, int x, int y, std::uint32_t sample_index, const Rgb& value) {
  PixelSums& sums = pixels_[offset(layer, x, y)];
  assert(sums.count + sums.rejected < max_samples);
  if (!in_range(value.r) || !in_range(value.g) || !in_range(value.b)) {
    sums.reject(sample_index);
    return false;
  }
  sums.r.add(value.r);
  sums.g.add(value.g);
  sums.b.add(value.b);
  sums.luminance_squared.add_square_of(wide_luminance(value.r, value.g, value.b));
  ++sums.count;
  return true;
}

const PixelSums& Film::pixel(std::size_t layer, int x, int y) const { return pixels_[offset(layer, x, y)]; }

std::uint64_t Film::rejected_count() const {
  std::uint64_t sum = 0;
  for (const PixelSums& sums : pixels_) sum += sums.rejected;
  return sum;
}

RejectedSample Film::first_rejected() const {
  for (int y = window_.y0; y < window_.y1; ++y)
    for (int x = window_.x0; x < window_.x1; ++x) {
      std::optional<RejectedSample> first;
      for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
        const PixelSums& sums = pixel(layer, x, y);
        if (sums.rejected > 0 && (!first || sums.rejected_index < first->index))
          first = RejectedSample{x, y, sums.rejected_index, layer};
      }
      if (first) return *first;
    }
  return {};
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
    const PixelSums& own = pixel(layer, x, y);
    if (std::uint64_t(own.count) + own.rejected + sums.count + sums.rejected > max_samples)
      throw Error(fmt::format("merged, pixel ({}, {}) has more than {} samples", x, y, max_samples));
  });
  other.for_each_sum(
      [&](std::size_t layer, int x, int y, const PixelSums& sums) { pixels_[offset(layer, x, y)] += sums; });
}

}  // namespace twinray

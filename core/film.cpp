// SPDX-License-Identifier: Apache-2.0
#include "core/film.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "core/exact_parts.h"

namespace twinray {
namespace {

/// In double, so that the variance of a constant pixel is 0 up to a double's rounding.
double wide_luminance(double r, double g, double b) { return 0.2126 * r + 0.7152 * g + 0.0722 * b; }

/// A part in fixed point; one that is too large for a colour, or none, leaves all to the others.
Int128 units_of_part(float x) { return std::fabs(x) <= Film::max_value ? fixed_units(x) : 0; }

bool in_range(float x) { return std::fabs(x) <= Film::max_value; }  // A NaN is not.

}  // namespace

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

Film::LayerPixels Film::make_pixels(Layer layer, std::size_t pixels) {
  switch (layer_info(layer).gathering) {
    case Gathering::mean:
    case Gathering::part:
      return MeanPixels(pixels, channel_count(layer));
    case Gathering::first:
      return FirstPixels(pixels, channel_count(layer));
    case Gathering::of_color:
      break;
  }
  return {};
}

Film::Film(int frame_width, int frame_height, PixelRect window, std::vector<Layer> layers)
    : frame_width_(frame_width), frame_height_(frame_height), window_(window), layers_(std::move(layers)) {
  constexpr int largest = 65536;
  if (frame_width < 1 || frame_width > largest || frame_height < 1 || frame_height > largest)
    throw Error(fmt::format("a frame of {} x {} pixels: each side must lie in 1 to {}", frame_width,
                            frame_height, largest));
  const bool is_near = window.x0 >= -largest && window.y0 >= -largest && window.x1 <= frame_width + largest &&
                       window.y1 <= frame_height + largest;
  if (!is_near || window.x0 >= window.x1 || window.y0 >= window.y1)
    throw Error(
        fmt::format("the window x {} to {}, y {} to {} is empty, or reaches more than {} pixels beyond the "
                    "frame of {} x {}",
                    window.x0, window.x1, window.y0, window.y1, largest, frame_width, frame_height));
  const std::size_t count = std::size_t(window.width()) * std::size_t(window.height());
  pixels_.resize(count);
  for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
    layer_pixels_.push_back(make_pixels(layers_[layer], count));
    if (is_part(layers_[layer])) parts_.push_back(layer);
  }
  check_parts();
}

void Film::check_parts() const {
  if (!parts_.empty() && parts_.size() != light_parts().size())
    throw Error(fmt::format("{} of the {} parts of light: a film keeps all of them or none", parts_.size(),
                            light_parts().size()));
}

std::size_t Film::offset(int x, int y) const {
  assert(x >= window_.x0 && x < window_.x1 && y >= window_.y0 && y < window_.y1);
  return std::size_t(y - window_.y0) * std::size_t(window_.width()) + std::size_t(x - window_.x0);
}

bool Film::add(int x, int y, std::uint32_t sample_index, const Rgb& color, std::span<const Rgb> values) {
  assert(values.size() == layers_.size());
  const std::size_t at = offset(x, y);
  PixelSums& sums = pixels_[at];
  assert(sums.count + sums.rejected < max_samples);
  if (!in_range(color.r) || !in_range(color.g) || !in_range(color.b)) {
    sums.reject(sample_index);
    return false;
  }
  sums.r.add(color.r);
  sums.g.add(color.g);
  sums.b.add(color.b);
  sums.luminance_squared.add_square_of(wide_luminance(color.r, color.g, color.b));
  ++sums.count;
  if (!parts_.empty()) add_parts(at, color, values);
  auto part = parts_.begin();
  for (std::size_t layer = 0; layer < layer_pixels_.size(); ++layer) {
    if (part != parts_.end() && *part == layer) {
      ++part;
      continue;
    }
    if (auto* const mean = std::get_if<MeanPixels>(&layer_pixels_[layer])) mean->add(at, values[layer]);
    if (auto* const first = std::get_if<FirstPixels>(&layer_pixels_[layer]))
      first->add(at, sample_index, values[layer]);
  }
  return true;
}

namespace {

constexpr float Rgb::*channels[] = {&Rgb::r, &Rgb::g, &Rgb::b};

/// The parts of one channel of a colour; there are no more than eight.
template <typename Number>
struct ChannelParts {
  std::array<Number, 8> numbers;
  std::span<Number> span(std::size_t count) { return std::span<Number>(numbers).first(count); }
};

}  // namespace

void Film::add_parts(std::size_t pixel, const Rgb& color, std::span<const Rgb> values) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const float whole = color.*channels[channel];
    if (whole == 0) continue;  // No part is negative: all are 0.
    // Most of the others are 0 as well.
    ChannelParts<Int128> parts;
    ChannelParts<std::size_t> layers;
    std::size_t count = 0;
    for (const std::size_t layer : parts_) {
      const float part = values[layer].*channels[channel];
      if (part == 0 && layer != parts_.front()) continue;
      layers.numbers[count] = layer;
      parts.numbers[count++] = units_of_part(part);
    }
    make_exact(fixed_units(whole), parts.span(count));
    for (std::size_t i = 0; i < count; ++i)
      std::get<MeanPixels>(layer_pixels_[layers.numbers[i]]).add_units(pixel, channel, parts.numbers[i]);
  }
}

Int128 Film::part_units(std::size_t layer, int x, int y, std::size_t channel) const {
  return std::get<MeanPixels>(layer_pixels_[layer]).units(offset(x, y), channel);
}

void Film::write_parts(std::size_t pixel, std::span<Rgb> values) const {
  const Rgb color = pixels_[pixel].mean();
  for (float Rgb::*const channel : channels) {
    ChannelParts<float> parts;
    for (std::size_t i = 0; i < parts_.size(); ++i) parts.numbers[i] = values[parts_[i]].*channel;
    make_exact(color.*channel, parts.span(parts_.size()));
    for (std::size_t i = 0; i < parts_.size(); ++i) values[parts_[i]].*channel = parts.numbers[i];
  }
}

Rgb Film::kept_value(std::size_t layer, std::size_t pixel) const {
  const PixelSums& sums = pixels_[pixel];
  if (const auto* const mean = std::get_if<MeanPixels>(&layer_pixels_[layer]))
    return mean->mean(pixel, sums.count);
  if (const auto* const first = std::get_if<FirstPixels>(&layer_pixels_[layer])) {
    const float nothing = layer_info(layers_[layer]).nothing;
    return first->has(pixel) ? first->value(pixel) : Rgb{nothing, nothing, nothing};
  }
  if (layers_[layer] == Layer::samples) return {float(sums.count), 0, 0};
  return {sums.count == 0 ? 0 : float(sums.luminance_variance() / sums.count), 0, 0};
}

void Film::read_values(int x, int y, std::span<Rgb> values) const {
  const std::size_t pixel = offset(x, y);
  for (std::size_t layer = 0; layer < layers_.size(); ++layer) values[layer] = kept_value(layer, pixel);
  if (!parts_.empty()) write_parts(pixel, values);
}

Rgb Film::value(std::size_t layer, int x, int y) const {
  std::vector<Rgb> values(layers_.size());
  read_values(x, y, values);
  return values[layer];
}

std::uint64_t Film::bytes(std::uint64_t pixels, std::span<const Layer> layers) {
  std::uint64_t bytes = sizeof(PixelSums);
  for (const Layer layer : layers) {
    const Gathering gathering = layer_info(layer).gathering;
    if (gathering == Gathering::mean || gathering == Gathering::part)
      bytes += MeanPixels::bytes(channel_count(layer));
    if (gathering == Gathering::first) bytes += FirstPixels::bytes(channel_count(layer));
  }
  return pixels * bytes;
}

std::uint64_t Film::rejected_count() const {
  std::uint64_t sum = 0;
  for (const PixelSums& sums : pixels_) sum += sums.rejected;
  return sum;
}

RejectedSample Film::first_rejected() const {
  for (int y = window_.y0; y < window_.y1; ++y)
    for (int x = window_.x0; x < window_.x1; ++x)
      if (const PixelSums& sums = pixel(x, y); sums.rejected > 0) return {x, y, sums.rejected_index};
  return {};
}

namespace {

std::string names_of(const std::vector<Layer>& layers) {
  std::string names = "color";
  for (const Layer layer : layers) names += fmt::format(", {}", layer_info(layer).name);
  return names;
}

}  // namespace

void Film::check_mergeable(const Film& other) const {
  if (other.frame_width_ != frame_width_ || other.frame_height_ != frame_height_)
    throw Error(fmt::format("films of different frames cannot be merged: {} x {} and {} x {} pixels",
                            frame_width_, frame_height_, other.frame_width_, other.frame_height_));
  if (other.layers_ != layers_)
    throw Error(fmt::format("films of different layers cannot be merged: {} and {}", names_of(layers_),
                            names_of(other.layers_)));
  const PixelRect& a = window_;
  const PixelRect& b = other.window_;
  if (b.x0 < a.x0 || b.y0 < a.y0 || b.x1 > a.x1 || b.y1 > a.y1)
    throw Error(fmt::format(
        "the window x {} to {}, y {} to {} cannot be merged into the smaller x {} to {}, y {} to {}", b.x0,
        b.x1, b.y0, b.y1, a.x0, a.x1, a.y0, a.y1));
  other.for_each_pixel([&](int x, int y) {
    const PixelSums &own = pixel(x, y), &sums = other.pixel(x, y);
    if (std::uint64_t(own.count) + own.rejected + sums.count + sums.rejected > max_samples)
      throw Error(fmt::format("merged, pixel ({}, {}) has more than {} samples", x, y, max_samples));
  });
}

void Film::merge_layer(LayerPixels& own, const LayerPixels& other, std::size_t to, std::size_t from) {
  if (auto* const mean = std::get_if<MeanPixels>(&own)) mean->merge(to, std::get<MeanPixels>(other), from);
  if (auto* const first = std::get_if<FirstPixels>(&own))
    first->merge(to, std::get<FirstPixels>(other), from);
}

void Film::merge(const Film& other) {
  check_mergeable(other);
  other.for_each_pixel([&](int x, int y) {
    const std::size_t to = offset(x, y), from = other.offset(x, y);
    pixels_[to] += other.pixels_[from];
    for (std::size_t layer = 0; layer < layers_.size(); ++layer)
      merge_layer(layer_pixels_[layer], other.layer_pixels_[layer], to, from);
  });
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "core/layer_pixels.h"

#include <cmath>

#include "core/columns.h"
#include "core/exact_parts.h"

namespace twinray {
namespace {

constexpr float Rgb::*channels[] = {&Rgb::r, &Rgb::g, &Rgb::b};

}  // namespace

void MeanPixels::add(std::size_t pixel, std::span<const Rgb> values) {
  sums_.add(pixel * channels_, channels_, values);
}

void MeanPixels::merge(std::size_t pixel, const MeanPixels& other, std::size_t other_pixel) {
  for (std::size_t channel = 0; channel < channels_; ++channel)
    sums_.add_units(pixel * channels_ + channel, other.sums_.units(other_pixel * channels_ + channel));
}

Rgb MeanPixels::mean(std::size_t pixel, std::uint32_t count) const {
  Rgb mean;
  for (std::size_t channel = 0; channel < channels_; ++channel)
    mean.*channels[channel] = sums_.mean(pixel * channels_ + channel, count);
  return mean;
}

void PartPixels::add(std::size_t pixel, std::span<const Rgb> parts) {
  for (std::size_t part = 0; part < parts_; ++part)
    sums_.add(3 * (pixel * parts_ + part), 3, parts.subspan(part), parts_);
}

void PartPixels::merge(std::size_t pixel, const PartPixels& other, std::size_t other_pixel) {
  for (std::size_t i = 0; i < parts_ * 3; ++i)
    sums_.add_units(pixel * parts_ * 3 + i, other.sums_.units(other_pixel * parts_ * 3 + i));
}

void PartPixels::read(std::size_t pixel, std::uint32_t count, const Rgb& mean, std::span<Rgb> parts) const {
  const std::size_t first = pixel * parts_ * 3;
  std::vector<float> of_channel(parts_);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    for (std::size_t part = 0; part < parts_; ++part)
      of_channel[part] = sums_.mean(first + 3 * part + channel, count);
    make_exact(mean.*channels[channel], of_channel);
    for (std::size_t part = 0; part < parts_; ++part) parts[part].*channels[channel] = of_channel[part];
  }
}

void FirstPixels::add(std::size_t pixel, std::uint32_t sample_index, const Rgb& value) {
  if (std::isnan(value.r) || sample_index >= indices_[pixel]) return;
  indices_[pixel] = sample_index;
  for (std::size_t channel = 0; channel < channels_; ++channel)
    values_[pixel * channels_ + channel] = value.*channels[channel];
}

void FirstPixels::merge(std::size_t pixel, const FirstPixels& other, std::size_t other_pixel) {
  if (other.has(other_pixel)) add(pixel, other.indices_[other_pixel], other.value(other_pixel));
}

Rgb FirstPixels::value(std::size_t pixel) const {
  Rgb value;
  for (std::size_t channel = 0; channel < channels_; ++channel)
    value.*channels[channel] = values_[pixel * channels_ + channel];
  return value;
}

void FirstPixels::save(std::size_t begin, std::size_t end, ColumnWriter& to) const {
  to.put(std::span(indices_).subspan(begin, end - begin));
  to.put(std::span(values_).subspan(begin * channels_, (end - begin) * channels_));
}

void FirstPixels::load(ColumnReader& from) {
  from.take(std::span(indices_));
  from.take(std::span(values_));
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "core/layer_pixels.h"

#include <algorithm>
#include <cmath>

namespace twinray {
namespace {

/// A channel of a colour, by its number.
float channel_of(const Rgb& value, std::size_t channel) {
  return channel == 0 ? value.r : channel == 1 ? value.g : value.b;
}

float& channel_of(Rgb& value, std::size_t channel) {
  return channel == 0 ? value.r : channel == 1 ? value.g : value.b;
}

float in_range(float x) { return std::isnan(x) ? 0 : std::clamp(x, -max_radiance, max_radiance); }

}  // namespace

void Carries::add(std::size_t place, std::int64_t carry) {
  const std::lock_guard lock(mutex_);
  if ((carries_[place] += carry) == 0) carries_.erase(place);
}

std::int64_t Carries::at(std::size_t place) const {
  if (carries_.empty()) return 0;
  const auto found = carries_.find(place);
  return found == carries_.end() ? 0 : found->second;
}

void MeanPixels::add_units(std::size_t pixel, std::size_t channel, Int128 units) {
  const std::size_t place = pixel * channels_ + channel;
  const Int128 sum = Int128(sums_[place]) + units;
  sums_[place] = std::int64_t(std::uint64_t(sum));
  const Int128 rest = sum - sums_[place];
  if (rest != 0) carries_.add(place, std::int64_t(rest >> 64));
}

void MeanPixels::add(std::size_t pixel, const Rgb& value) {
  for (std::size_t channel = 0; channel < channels_; ++channel) {
    const float x = channel_of(value, channel);
    std::int64_t& sum = sums_[pixel * channels_ + channel];
    std::int64_t longer = 0;
    // Nearly always one word is enough.
    if (std::fabs(x) < 0x1p19f && !__builtin_add_overflow(sum, std::llrint(x * 0x1p43), &longer))
      sum = longer;
    else
      add_units(pixel, channel, fixed_units(in_range(x)));
  }
}

void MeanPixels::merge(std::size_t pixel, const MeanPixels& other, std::size_t other_pixel) {
  for (std::size_t channel = 0; channel < channels_; ++channel)
    add_units(pixel, channel, other.units(other_pixel, channel));
}

Int128 MeanPixels::units(std::size_t pixel, std::size_t channel) const {
  const std::size_t place = pixel * channels_ + channel;
  return Int128(carries_.at(place)) * (Int128(1) << 64) + sums_[place];
}

Rgb MeanPixels::mean(std::size_t pixel, std::uint32_t count) const {
  Rgb mean;
  if (count == 0) return mean;
  for (std::size_t channel = 0; channel < channels_; ++channel)
    channel_of(mean, channel) = float(double(units(pixel, channel)) * fixed_unit / count);
  return mean;
}

void FirstPixels::add(std::size_t pixel, std::uint32_t sample_index, const Rgb& value) {
  if (std::isnan(value.r) || sample_index >= indices_[pixel]) return;
  indices_[pixel] = sample_index;
  for (std::size_t channel = 0; channel < channels_; ++channel)
    values_[pixel * channels_ + channel] = channel_of(value, channel);
}

void FirstPixels::merge(std::size_t pixel, const FirstPixels& other, std::size_t other_pixel) {
  if (other.has(other_pixel)) add(pixel, other.indices_[other_pixel], other.value(other_pixel));
}

Rgb FirstPixels::value(std::size_t pixel) const {
  Rgb value;
  for (std::size_t channel = 0; channel < channels_; ++channel)
    channel_of(value, channel) = values_[pixel * channels_ + channel];
  return value;
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Private: the error of filters of both halves, by the halves alone (blend.h says how).
#pragma once
#include <array>
#include <cstddef>
#include <span>

#include "core/image_error.h"
#include "integrators/denoise/half_pictures.h"

namespace twinray {

/// The expected product of the errors of two filters' pictures, in one pixel and channel, relative to its
/// square.
struct ErrorProduct {
  const HalfPictures& noisy;
  const FilteredHalves &first, &second;
  std::span<const Plane> level;  ///< By which errors are divided.

  float operator()(std::size_t pixel, std::size_t channel) const {
    return bias(pixel, channel) + noise(pixel, channel);
  }

  /// What both do to the picture without noise. Where the halves are stratified their noise is not
  /// independent: it makes this smaller, and negative where there is no bias.
  float bias(std::size_t pixel, std::size_t channel) const {
    const float a = noisy.halves[0].color[channel].values[pixel];
    const float b = noisy.halves[1].color[channel].values[pixel];
    const auto [first_a, first_b] = of(first, pixel, channel);
    const auto [second_a, second_b] = of(second, pixel, channel);
    return 0.5f * ((first_a - a) * (second_b - b) + (second_a - a) * (first_b - b)) / scale(pixel, channel);
  }

  /// What they leave of the noise.
  float noise(std::size_t pixel, std::size_t channel) const {
    const float weight = noisy.second_weight.values[pixel];
    const auto [first_a, first_b] = of(first, pixel, channel);
    const auto [second_a, second_b] = of(second, pixel, channel);
    return weight * (1 - weight) * (first_a - first_b) * (second_a - second_b) / scale(pixel, channel);
  }

 private:
  static std::array<float, 2> of(const FilteredHalves& halves, std::size_t pixel, std::size_t channel) {
    return {halves[0][channel].values[pixel], halves[1][channel].values[pixel]};
  }
  float scale(std::size_t pixel, std::size_t channel) const {
    const float by = level[channel].values[pixel];
    return by * by + float(least_relative_square);
  }
};

/// Errors are means over squares of this radius, twice.
inline constexpr int error_radius = 3;

}  // namespace twinray

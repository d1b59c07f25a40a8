// SPDX-License-Identifier: Apache-2.0
#include "integrators/adaptive.h"

#include <cmath>

namespace twinray {
namespace {

constexpr double cs184_standard_errors = 1.96;  // 95 % of a normal distribution
constexpr double standard_errors = 3.5;         // 99.95 %
/// Brightness, in means, of a sample that might have been missed.
constexpr double unseen = 2;

}  // namespace

bool has_enough_samples(const PixelSums& pixel, const AdaptiveSampling& adaptive) {
  if (pixel.count < 2) return false;
  const double n = pixel.count, mean = pixel.luminance_mean(), variance = pixel.luminance_variance();
  if (adaptive.rule == AdaptiveRule::cs184)
    return cs184_standard_errors * std::sqrt(variance / n) <= adaptive.tolerance * mean;
  const double with_unseen = variance + unseen * mean * (unseen * mean) / n;
  return mean > 0 && standard_errors * std::sqrt(with_unseen / n) <= adaptive.tolerance * mean;
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "integrators/denoise/denoise.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "integrators/denoise/blend.h"
#include "integrators/denoise/box_mean.h"
#include "integrators/denoise/regression.h"

namespace twinray {
namespace {

/// The variance of a single pixel, by its halves alone, says little: it is a mean over the pixels beside it.
constexpr int variance_radius = 1;

std::vector<Plane> variances(std::span<const Plane> a, std::span<const Plane> b, const Plane& second_weight) {
  std::vector<Plane> found;
  for (std::size_t i = 0; i < a.size(); ++i)
    found.push_back(box_mean(half_variance(a[i], b[i], second_weight), variance_radius));
  return found;
}

/// Of one half, from that of both.
std::vector<Plane> of_half(std::vector<Plane> variances) {
  for (Plane& plane : variances)
    for (float& value : plane.values) value *= 2;
  return variances;
}

Plane ones(int width, int height) {
  Plane plane(width, height);
  std::fill(plane.values.begin(), plane.values.end(), 1.0f);
  return plane;
}

}  // namespace

FilteredHalves denoised_halves(const HalfPictures& noisy, const std::function<bool()>& is_stopped) {
  const auto& [a, b] = noisy.halves;
  if (a.features.size() != feature_count || b.features.size() != feature_count)
    throw Error(fmt::format("{} features: a picture is denoised by {}", a.features.size(), feature_count));
  const std::vector<Plane> variance = of_half(variances(a.color, b.color, noisy.second_weight));
  RegressionInput input{{},
                        padded(means_of_halves(a.features, b.features, noisy.second_weight)),
                        padded(variances(a.features, b.features, noisy.second_weight)),
                        PaddedPlane(ones(noisy.width, noisy.height), Beyond::zero),
                        {{}, padded(variance)}};
  std::array<FilteredHalves, bandwidths.size()> filtered;
  for (std::size_t half = 0; half < 2; ++half) {
    // The weights are those of the other half: noise must not choose neighbours that are like it.
    input.color = padded(noisy.halves[half].color);
    input.guide.color = padded(noisy.halves[1 - half].color);
    const auto found = regressions(input, noisy.width, noisy.height, is_stopped);
    for (std::size_t k = 0; k < bandwidths.size(); ++k) filtered[k][half] = found[k];
  }
  return best_blend(noisy, filtered);
}

Image picture_of(const FilteredHalves& halves, const Plane& second_weight) {
  std::vector<Plane> mean = means_of_halves(halves[0], halves[1], second_weight);
  for (Plane& channel : mean)
    for (float& value : channel.values) value = std::max(0.0f, value);
  return image_of(mean);
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// How well a render knows its pixels: what its layers of variance and samples say.
#pragma once
#include <string>
#include <vector>

#include "check/picture_error.h"
#include "check/welch.h"

namespace twinray::compare {

/// Of each pixel.
struct PixelNoise {
  std::vector<float> variances;  ///< Of the mean luminance.
  std::vector<float> samples;

  bool is_known() const { return !variances.empty() && !samples.empty(); }
  /// What a pixel of this colour is known to be.
  MeanEstimate estimate(const Rgb& mean, std::size_t i) const {
    return {double(luminance(mean)), double(variances[i]), double(samples[i]) - 1};
  }
};

/// From the channels variance.Y and samples of an EXR; not known where one of them is missing. Throws Error.
PixelNoise read_pixel_noise(const std::string& path);

/// Those with two samples at least and a finite variance in both: of a single sample there is none.
PixelMask pixels_with_noise(const PixelNoise& a, const PixelNoise& b);

}  // namespace twinray::compare

// SPDX-License-Identifier: Apache-2.0
#include "cli/compare/pixel_noise.h"

#include <cmath>

#include "io/picture/image_file.h"

namespace twinray::compare {
namespace {

bool has_noise(const PixelNoise& noise, std::size_t i) {
  return noise.samples[i] >= 2 && std::isfinite(noise.samples[i]) && noise.variances[i] >= 0 &&
         std::isfinite(noise.variances[i]);
}

}  // namespace

PixelNoise read_pixel_noise(const std::string& path) {
  return {read_channel(path, "variance.Y"), read_channel(path, "samples.X")};
}

PixelMask pixels_with_noise(const PixelNoise& a, const PixelNoise& b) {
  PixelMask mask(a.samples.size());
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = has_noise(a, i) && has_noise(b, i);
  return mask;
}

}  // namespace twinray::compare

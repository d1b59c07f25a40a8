// SPDX-License-Identifier: Apache-2.0
#include "check/picture_error.h"

#include "core/error.h"
#include "core/same_size.h"

namespace twinray {
namespace {

double square(double x) { return x * x; }

/// `difference(i)` is that of pixel i, an Rgb.
template <class Difference>
SquaredError mean_of(const Image& converged, const PixelMask& mask, const Difference& difference) {
  SquaredError sum;
  std::size_t count = 0;
  for (std::size_t i = 0; i < converged.pixels.size(); ++i) {
    if (!mask[i]) continue;
    const Rgb d = difference(i), &c = converged.pixels[i];
    sum.mse += square(d.r) + square(d.g) + square(d.b);
    sum.relative += relative_square(d.r, c.r) + relative_square(d.g, c.g) + relative_square(d.b, c.b);
    count += 3;
  }
  return count == 0 ? SquaredError{} : SquaredError{sum.mse / double(count), sum.relative / double(count)};
}

void check_sizes(const Image& image, const ConvergedPicture& converged, const PixelMask& mask) {
  check_same_size(image, converged.mean);
  if (mask.size() != image.pixels.size()) throw Error("the mask has another size than the picture");
}

}  // namespace

ConvergedPicture converged_picture(const Image& a, const Image& b) {
  Image mean(a.width, a.height), noise(a.width, a.height);
  for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
    mean.pixels[i] = 0.5f * (a.pixels[i] + b.pixels[i]);
    noise.pixels[i] = 0.5f * (a.pixels[i] - b.pixels[i]);
  }
  return {std::move(mean), std::move(noise)};
}

SquaredError squared_error(const Image& image, const ConvergedPicture& converged, const PixelMask& mask) {
  check_sizes(image, converged, mask);
  return mean_of(converged.mean, mask,
                 [&](std::size_t i) { return image.pixels[i] - converged.mean.pixels[i]; });
}

SquaredError own_error(const ConvergedPicture& converged, const PixelMask& mask) {
  if (!converged.noise) return {};
  check_sizes(*converged.noise, converged, mask);
  return mean_of(converged.mean, mask, [&](std::size_t i) { return converged.noise->pixels[i]; });
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "core/image_error.h"

#include <cmath>

#include "core/same_size.h"

namespace twinray {

ImageError image_error(const Image& image, const Image& converged) {
  check_same_size(image, converged);
  double squares = 0, sum = 0, expected_sum = 0;
  for (std::size_t i = 0; i < converged.pixels.size(); ++i) {
    const double value = luminance(image.pixels[i]), expected = luminance(converged.pixels[i]);
    squares += (value - expected) * (value - expected);
    sum += value;
    expected_sum += expected;
  }
  if (!(expected_sum > 0)) return {};
  const auto pixels = double(converged.pixels.size());
  return {std::sqrt(squares / pixels) / (expected_sum / pixels), sum / expected_sum - 1};
}

}  // namespace twinray

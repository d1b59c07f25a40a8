// SPDX-License-Identifier: Apache-2.0
#include "integrators/denoise/filtered_error.h"

#include <algorithm>
#include <cmath>

#include "integrators/denoise/box_mean.h"
#include "integrators/denoise/error_product.h"

namespace twinray {

double estimated_relative_error(const HalfPictures& noisy, const FilteredHalves& filtered) {
  const std::vector<Plane> mean = means_of_halves(filtered[0], filtered[1], noisy.second_weight);
  const ErrorProduct error{noisy, filtered, filtered, mean};
  Plane bias(noisy.width, noisy.height);
  double noise = 0;
  for (std::size_t pixel = 0; pixel < bias.values.size(); ++pixel)
    for (std::size_t channel = 0; channel < 3; ++channel) {
      bias.values[pixel] += error.bias(pixel, channel);
      noise += double(error.noise(pixel, channel));
    }
  double positive_bias = 0;
  for (const float value : box_mean(box_mean(bias, error_radius), error_radius).values)
    positive_bias += std::max(0.0, double(value));
  return std::sqrt((noise + positive_bias) / (3.0 * double(bias.values.size())));
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "core/distribution.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.h"

namespace twinray {

Distribution::Distribution(std::span<const double> weights) {
  sums_.reserve(weights.size() + 1);
  double sum = 0;
  for (const double weight : weights) {
    if (!(weight >= 0) || !std::isfinite(sum + weight))
      throw Error(
          fmt::format("weight {} of a distribution is {} after a sum of {}: all must be finite and >= 0",
                      size(), weight, sum));
    if (sum + weight > sum) last_ = size();
    sum += weight;
    sums_.push_back(sum);
  }
}

float Distribution::probability(std::uint32_t index) const {
  const double weight = sums_[index + 1] - sums_[index];
  if (weight == 0) return 0;
  return std::max(float(weight / total()), std::numeric_limits<float>::min());
}

}  // namespace twinray

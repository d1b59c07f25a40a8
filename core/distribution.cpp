// SPDX-License-Identifier: Apache-2.0
#include "core/distribution.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.h"

namespace twinray {

Distribution::Distribution(std::span<const double> weights) {
  cumulative_.reserve(weights.size());
  double sum = 0;
  for (const double weight : weights) {
    if (!(weight >= 0) || !std::isfinite(sum + weight))
      throw Error(
          fmt::format("weight {} of a distribution is {} after a sum of {}: all must be finite and >= 0",
                      cumulative_.size(), weight, sum));
    sum += weight;
    cumulative_.push_back(sum);
  }
}

float Distribution::probability(std::uint32_t index) const {
  const double weight = cumulative_[index] - before(index);
  if (weight == 0) return 0;
  return std::max(float(weight / total()), std::numeric_limits<float>::min());
}

Distribution::Choice Distribution::sample(float u) const {
  assert(total() > 0);
  const double target = double(u) * total();
  auto chosen = std::upper_bound(cumulative_.begin(), cumulative_.end(), target);
  // A tiny total rounds the target up to itself: the last index with a weight, then.
  if (chosen == cumulative_.end()) chosen = std::lower_bound(cumulative_.begin(), cumulative_.end(), total());
  const std::uint32_t index = std::uint32_t(chosen - cumulative_.begin());
  const float remainder = float((target - before(index)) / (*chosen - before(index)));
  return {index, probability(index), std::min(remainder, 0x1.fffffep-1f)};
}

}  // namespace twinray

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

void Distribution::sample(std::span<const Distribution* const> of, std::span<const float> u,
                          std::span<Choice> choices) {
  assert(of.size() <= most_together);
  std::size_t first[most_together], left[most_together];
  double target[most_together];
  std::size_t longest = 0;
  for (std::size_t i = 0; i < of.size(); ++i) {
    first[i] = 0;
    left[i] = of[i]->last_;
    target[i] = double(u[i]) * of[i]->total();
    longest = std::max(longest, left[i]);
  }
  for (; longest > 0; longest /= 2)
    for (std::size_t i = 0; i < of.size(); ++i) {  // A step of first_above(), which does nothing at the end.
      const std::size_t half = (left[i] + 1) / 2;
      first[i] += half * (of[i]->sums_[first[i] + half] <= target[i]);
      left[i] /= 2;
    }
  for (std::size_t i = 0; i < of.size(); ++i) choices[i] = of[i]->choice(target[i], first[i]);
}

}  // namespace twinray

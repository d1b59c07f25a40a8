// SPDX-License-Identifier: Apache-2.0
#include "core/distribution.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.h"

namespace twinray {
namespace {

/// So many indices, about, for each part of the guide table: their sums lie in one or two lines of a cache.
constexpr std::size_t indices_per_part = 4;

}  // namespace

Distribution::Distribution(std::span<const double> weights) {
  sums_.reserve(weights.size() + 1);
  double sum = 0;
  std::uint32_t last = 0;
  for (const double weight : weights) {
    if (!(weight >= 0) || !std::isfinite(sum + weight))
      throw Error(
          fmt::format("weight {} of a distribution is {} after a sum of {}: all must be finite and >= 0",
                      size(), weight, sum));
    if (sum + weight > sum) last = std::uint32_t(size());
    sum += weight;
    sums_.push_back(sum);
  }
  make_guide(last);
}

void Distribution::make_guide(std::uint32_t last) {
  const std::size_t parts = std::bit_floor(std::max(size() / indices_per_part, std::size_t(1)));
  guide_.clear();
  std::uint32_t index = 0;
  for (std::size_t part = 0; part <= parts; ++part) {
    const double target = double(part) / double(parts) * total();
    while (index < last && sums_[index + 1] <= target) ++index;
    guide_.push_back(index);
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
  Search searches[most_together];
  double targets[most_together];
  for (std::size_t i = 0; i < of.size(); ++i) __builtin_prefetch(&of[i]->guide_[of[i]->part_of(u[i])]);
  std::size_t longest = 0;
  for (std::size_t i = 0; i < of.size(); ++i) {
    targets[i] = double(u[i]) * of[i]->total();
    searches[i] = of[i]->guide(u[i]);
    __builtin_prefetch(&of[i]->sums_[searches[i].first]);
    longest = std::max(longest, searches[i].left);
  }
  for (; longest > 0; longest /= 2)
    for (std::size_t i = 0; i < of.size(); ++i)
      of[i]->step(searches[i], targets[i]);  // At the end, of nothing.
  for (std::size_t i = 0; i < of.size(); ++i) choices[i] = of[i]->choice(targets[i], searches[i].first);
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace twinray {

/// Chooses an index with a probability proportional to its weight.
class Distribution {
 public:
  struct Choice {
    std::uint32_t index;
    float remainder;  ///< Uniform in [0, 1) again: the draw within the chosen index.
  };

  Distribution() = default;
  /// Throws Error unless the weights and their sum are finite and >= 0. If all are zero (or there is none)
  /// total() is 0 and nothing may be sampled.
  explicit Distribution(std::span<const double> weights);

  double total() const { return cumulative_.empty() ? 0 : cumulative_.back(); }
  std::size_t size() const { return cumulative_.size(); }
  /// The probability that `sample` chooses the index; 0 for weight zero, else at least 2^-126, so that it can
  /// be divided by.
  float probability(std::uint32_t index) const;
  /// u in [0, 1). Never an index of weight zero.
  Choice sample(float u) const {
    assert(total() > 0);
    const double target = double(u) * total();
    const std::size_t index = first_above(target);
    const double start = before(index);
    const float remainder = float((target - start) / (cumulative_[index] - start));
    return {std::uint32_t(index), std::min(remainder, 0x1.fffffep-1f)};
  }

 private:
  double before(std::size_t index) const { return index == 0 ? 0 : cumulative_[index - 1]; }
  /// The first index whose sum lies above the target, but last_ at most: a tiny total rounds the target up to
  /// itself.
  std::size_t first_above(double target) const {
    // Halves the range without a branch: no processor can foresee where a draw falls.
    std::size_t first = 0;
    for (std::size_t count = last_; count > 0; count /= 2) {
      const std::size_t half = (count + 1) / 2;
      first += half * (cumulative_[first + half - 1] <= target);
    }
    return first;
  }

  std::vector<double> cumulative_;  ///< Inclusive sums of the weights.
  std::size_t last_ = 0;            ///< The last index whose weight has raised the sum.
};

}  // namespace twinray

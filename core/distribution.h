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

  double total() const { return sums_.back(); }
  std::size_t size() const { return sums_.size() - 1; }
  /// The probability that `sample` chooses the index; 0 for weight zero, else at least 2^-126, so that it can
  /// be divided by.
  float probability(std::uint32_t index) const;
  /// Asks memory for what probability() reads.
  void prefetch(std::uint32_t index) const { __builtin_prefetch(&sums_[index]); }
  /// u in [0, 1). Never an index of weight zero.
  Choice sample(float u) const {
    assert(total() > 0);
    return choice(double(u) * total(), first_above(double(u) * total()));
  }
  /// choices[i] = of[i]->sample(u[i]), up to so many: searched side by side, so that they wait for memory
  /// together.
  static constexpr std::size_t most_together = 64;
  static void sample(std::span<const Distribution* const> of, std::span<const float> u,
                     std::span<Choice> choices);

 private:
  Choice choice(double target, std::size_t index) const {
    const float remainder = float((target - sums_[index]) / (sums_[index + 1] - sums_[index]));
    return {std::uint32_t(index), std::min(remainder, 0x1.fffffep-1f)};
  }
  /// The first index whose weight brings the sum above the target, but last_ at most: a tiny total rounds the
  /// target up to itself.
  std::size_t first_above(double target) const {
    // Halves the range without a branch: no processor can foresee where a draw falls.
    std::size_t first = 0;
    for (std::size_t count = last_; count > 0; count /= 2) {
      const std::size_t half = (count + 1) / 2;
      first += half * (sums_[first + half] <= target);
    }
    return first;
  }

  std::vector<double> sums_{0};  ///< Of the weights before each index, and of all.
  std::size_t last_ = 0;         ///< The last index whose weight has raised the sum.
};

}  // namespace twinray

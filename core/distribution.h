// SPDX-License-Identifier: Apache-2.0
#pragma once
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
    float probability;  ///< Of this index; at least 2^-126, so that it can be divided by.
    float remainder;    ///< Uniform in [0, 1) again: the draw within the chosen index.
  };

  Distribution() = default;
  /// Throws Error unless the weights and their sum are finite and >= 0. If all are zero (or there is none)
  /// total() is 0 and nothing may be sampled.
  explicit Distribution(std::span<const double> weights);

  double total() const { return cumulative_.empty() ? 0 : cumulative_.back(); }
  std::size_t size() const { return cumulative_.size(); }
  /// The probability that `sample` chooses the index; 0 for weight zero.
  float probability(std::uint32_t index) const;
  /// u in [0, 1). Never an index of weight zero.
  Choice sample(float u) const;

 private:
  double before(std::size_t index) const { return index == 0 ? 0 : cumulative_[index - 1]; }

  std::vector<double> cumulative_;  ///< Inclusive sums of the weights.
};

}  // namespace twinray

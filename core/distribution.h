// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace twinray {

/// Chooses an index with a probability proportional to its weight. A guide table says for each of some equal
/// parts of [0, 1) among which indices its draws fall: a few, so that little is left to search (Chen and
/// Asau, "On Generating Random Variates from an Empirical Distribution", 1974).
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
    const double target = double(u) * total();
    Search search = guide(u);
    while (search.left > 0) step(search, target);
    return choice(target, search.first);
  }
  /// choices[i] = of[i]->sample(u[i]), up to so many: searched side by side, so that they wait for memory
  /// together.
  static constexpr std::size_t most_together = 64;
  static void sample(std::span<const Distribution* const> of, std::span<const float> u,
                     std::span<Choice> choices);

 private:
  /// For the first index whose weight brings the sum above a target: it is `first`, or one of `left` behind
  /// it.
  struct Search {
    std::size_t first, left;
  };

  /// The part of [0, 1) that a draw is in: their number is a power of two, so nothing is rounded.
  std::size_t part_of(float u) const { return std::size_t(u * float(guide_.size() - 1)); }
  Search guide(float u) const {
    const std::uint32_t* const part = &guide_[part_of(u)];
    return {part[0], part[1] - part[0]};
  }
  /// Halves the range without a branch: no processor can foresee where a draw falls.
  void step(Search& search, double target) const {
    const std::size_t half = (search.left + 1) / 2;
    search.first += half * (sums_[search.first + half] <= target);
    search.left /= 2;
  }
  Choice choice(double target, std::size_t index) const {
    const float remainder = float((target - sums_[index]) / (sums_[index + 1] - sums_[index]));
    return {std::uint32_t(index), std::min(remainder, 0x1.fffffep-1f)};
  }
  void make_guide(std::uint32_t last);

  std::vector<double> sums_{0};  ///< Of the weights before each index, and of all.
  /// Of the draw where each part begins, and of 1, the index that it chooses. Never beyond the last one whose
  /// weight has raised the sum: a tiny total rounds a target up to itself.
  std::vector<std::uint32_t> guide_{0, 0};
};

}  // namespace twinray

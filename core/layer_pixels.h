// SPDX-License-Identifier: Apache-2.0
// How a film keeps one layer: at most 8 bytes a channel and pixel. Pixels count row by row. Different threads
// may add to different pixels at the same time.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <vector>

#include "core/fixed_sum.h"
#include "core/rgb.h"

namespace twinray {

/// What sums of 64 bits cannot hold: for the few that are too large, how often each has overflowed.
class Carries {
 public:
  Carries() = default;
  Carries(const Carries& other) : carries_(other.carries_) {}
  Carries& operator=(const Carries& other) {
    carries_ = other.carries_;
    return *this;
  }
  void add(std::size_t place, std::int64_t carry);
  /// Not while others add.
  std::int64_t at(std::size_t place) const;

 private:
  std::mutex mutex_;
  std::map<std::size_t, std::int64_t> carries_;  ///< None of them 0.
};

/// A layer whose pixels have the means of their samples: exact sums in units of 2^-43, as those of the
/// colours. A sum up to 10^6 takes 8 bytes; the rest of a larger one is kept apart, so that no sum has a
/// limit.
class MeanPixels {
 public:
  MeanPixels(std::size_t pixels, std::size_t channels) : channels_(channels), sums_(pixels * channels) {}
  /// Adds one sample. What is not a number counts as 0, what lies beyond +-max_radiance as that.
  void add(std::size_t pixel, const Rgb& value);
  void add_units(std::size_t pixel, std::size_t channel, Int128 units);
  void merge(std::size_t pixel, const MeanPixels& other, std::size_t other_pixel);
  /// Of so many samples; black of none.
  Rgb mean(std::size_t pixel, std::uint32_t count) const;
  /// The sum of one channel.
  Int128 units(std::size_t pixel, std::size_t channel) const;
  static constexpr std::size_t bytes(std::size_t channels) { return channels * sizeof(std::int64_t); }

 private:
  std::size_t channels_;
  std::vector<std::int64_t> sums_;  ///< Modulo 2^64.
  Carries carries_;
};

/// A layer whose pixels have the value of one of their samples: of those that have a value at all the one
/// with the least index.
class FirstPixels {
 public:
  FirstPixels(std::size_t pixels, std::size_t channels)
      : channels_(channels), indices_(pixels, none), values_(pixels * channels) {}
  /// A sample has no value where its first channel is not a number.
  void add(std::size_t pixel, std::uint32_t sample_index, const Rgb& value);
  void merge(std::size_t pixel, const FirstPixels& other, std::size_t other_pixel);
  bool has(std::size_t pixel) const { return indices_[pixel] != none; }
  Rgb value(std::size_t pixel) const;
  static constexpr std::size_t bytes(std::size_t channels) {
    return sizeof(std::uint32_t) + channels * sizeof(float);
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;

  std::size_t channels_;
  std::vector<std::uint32_t> indices_;
  std::vector<float> values_;
};

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Many exact sums, of 8 bytes each: in units of 2^-43, as those of a film's colours.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <span>
#include <vector>

#include "core/fixed_sum.h"
#include "core/rgb.h"

namespace twinray {

class ColumnReader;
class ColumnWriter;

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
  /// Not while others add, as the functions below.
  std::int64_t at(std::size_t place) const;
  /// Those of the places [begin, end), which count from `begin` on in the columns.
  void save(std::size_t begin, std::size_t end, ColumnWriter& to) const;
  /// In place of all that are there, for so many places. Throws Error for others.
  void load(std::size_t places, ColumnReader& from);

 private:
  std::mutex mutex_;
  std::map<std::size_t, std::int64_t> carries_;  ///< None of them 0.
};

/// Sums up to 10^6 take 8 bytes; the rest of a larger one is kept apart, so that no sum has a limit.
/// Different threads may add to different sums at the same time.
class ExactSums {
 public:
  explicit ExactSums(std::size_t count) : sums_(count) {}
  /// Adds the first `channels` of each `stride`-th colour to as many sums from `place` on, each number
  /// rounded to the nearest unit. What is not a number counts as 0, what lies beyond +-max_radiance as that.
  void add(std::size_t place, std::size_t channels, std::span<const Rgb> colors, std::size_t stride = 1);
  void add_units(std::size_t place, Int128 units);
  Int128 units(std::size_t place) const;
  /// One of the sums over a number of samples; 0 for none.
  float mean(std::size_t place, std::uint32_t count) const;
  /// The sums [begin, end) as columns, not while others add; and all sums from columns of as many. Throws
  /// Error.
  void save(std::size_t begin, std::size_t end, ColumnWriter& to) const;
  void load(ColumnReader& from);
  static constexpr std::size_t bytes = sizeof(std::int64_t);  ///< Of each.

 private:
  std::vector<std::int64_t> sums_;  ///< Modulo 2^64.
  Carries carries_;
};

}  // namespace twinray

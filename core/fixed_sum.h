// SPDX-License-Identifier: Apache-2.0
// Sums in fixed point: addition is exact, so it has neither order nor rounding.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/radiance.h"
#include "core/rgb.h"

namespace twinray {

__extension__ using Int128 = __int128;
__extension__ using Unsigned128 = unsigned __int128;

/// Of all sums of single numbers.
inline constexpr double fixed_unit = 0x1p-43;
/// x in this unit, rounded to the nearest. |x| <= max_radiance.
Int128 fixed_units(double x);
/// The sum of those of one channel of colours, of which each `stride`-th counts. What lies beyond the range
/// counts as its end, and no number as 0.
Int128 fixed_units(std::span<const Rgb> colors, float Rgb::*channel, std::size_t stride = 1);

/// A sum of radiances in 96-bit fixed point, unit 2^-43.
class FixedSum {
 public:
  /// Adds x, rounded to the nearest unit. |x| <= max_radiance; the sum of up to 2^22 such numbers does not
  /// overflow.
  void add(double x) { add_units(fixed_units(x)); }
  /// Adds a sum of such numbers.
  void add_units(Int128 units);
  FixedSum& operator+=(const FixedSum& other);
  Int128 units() const;
  /// The sum, rounded to double.
  double value() const;
  friend bool operator==(const FixedSum&, const FixedSum&) = default;

 private:
  std::array<std::uint32_t, 3> words_{};  ///< Two's complement, the least word first.
};

/// A sum of squares of radiances in 128-bit fixed point, unit 2^-46.
class FixedSquareSum {
 public:
  /// Adds x^2, rounded up to the unit, so that what is too dim to be resolved counts as noise and not as
  /// certainty. |x| <= max_radiance up to a double's rounding; the sum of up to 2^22 such squares does not
  /// overflow.
  void add_square_of(double x) {
    const double square = x * x;
    if (!(square < one_word)) return add_wide(square);
    const double scaled = square * 0x1p46;
    const auto whole = std::int64_t(scaled);
    units_ += std::uint64_t(whole + (double(whole) < scaled));
  }
  FixedSquareSum& operator+=(const FixedSquareSum& other);
  /// The sum, rounded to double.
  double value() const;
  friend bool operator==(const FixedSquareSum&, const FixedSquareSum&) = default;

 private:
  /// Squares below that have few enough units for a word of 64 bits.
  static constexpr double one_word = 0x1p16;
  void add_wide(double square);

  Unsigned128 units_ = 0;
};

}  // namespace twinray

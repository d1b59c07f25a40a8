// SPDX-License-Identifier: Apache-2.0
#include "core/fixed_sum.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace twinray {
namespace {

using Words = std::array<std::uint32_t, 3>;

Int128 units_of(const Words& words) {
  return Int128(std::int32_t(words[2])) * (Int128(1) << 64) + (std::uint64_t(words[1]) << 32 | words[0]);
}

Words words_of(Int128 units) {
  return {std::uint32_t(units), std::uint32_t(units >> 32), std::uint32_t(units >> 64)};
}

float clamped(float x) { return std::isnan(x) ? 0 : std::clamp(x, -max_radiance, max_radiance); }

}  // namespace

Int128 fixed_units(double x) {
  assert(std::fabs(x) <= max_radiance);
  constexpr double one_word = 0x1p19;
  if (std::fabs(x) < one_word) return std::llrint(x * 0x1p43);
  // Whole units of 2^-11, and what is left of x in units of 2^-43: nothing is rounded but the last one.
  const double scaled = x * 0x1p11;
  const double upper = std::trunc(scaled);
  return (Int128(std::int64_t(upper)) << 32) + std::llrint((scaled - upper) * 0x1p32);
}

/// Nearly always one word is enough: where the sum of their absolute values is below 2^19, its rounding
/// included, that of their units, which are 2^43 times as large, is below 2^63.
Int128 fixed_units(std::span<const Rgb> colors, float Rgb::*channel, std::size_t stride) {
  float size = 0;
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < colors.size(); i += stride) {
    const float x = colors[i].*channel;
    size += std::fabs(x);
    sum += std::uint64_t(std::llrint(x * 0x1p43));
  }
  if (size < 0x1p19f) return std::int64_t(sum);
  Int128 wide = 0;
  for (std::size_t i = 0; i < colors.size(); i += stride) wide += fixed_units(clamped(colors[i].*channel));
  return wide;
}

void FixedSum::add_units(Int128 units) { words_ = words_of(units_of(words_) + units); }

FixedSum& FixedSum::operator+=(const FixedSum& other) {
  words_ = words_of(units_of(words_) + units_of(other.words_));
  return *this;
}

Int128 FixedSum::units() const { return units_of(words_); }

double FixedSum::value() const { return double(units()) * fixed_unit; }

void FixedSquareSum::add_wide(double square) {
  assert(square < 0x1.0001p60);
  const double upper = std::trunc(square);
  const auto lower = std::uint64_t(std::ceil((square - upper) * 0x1p46));
  units_ += (Unsigned128(std::uint64_t(upper)) << 46) + lower;
}

FixedSquareSum& FixedSquareSum::operator+=(const FixedSquareSum& other) {
  units_ += other.units_;
  return *this;
}

double FixedSquareSum::value() const { return double(units_) * 0x1p-46; }

}  // namespace twinray

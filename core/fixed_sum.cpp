// SPDX-License-Identifier: Apache-2.0
#include "core/fixed_sum.h"

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

void FixedSum::add(double x) { words_ = words_of(units_of(words_) + fixed_units(x)); }

FixedSum& FixedSum::operator+=(const FixedSum& other) {
  words_ = words_of(units_of(words_) + units_of(other.words_));
  return *this;
}

Int128 FixedSum::units() const { return units_of(words_); }

double FixedSum::value() const { return double(units()) * fixed_unit; }

void FixedSquareSum::add_square_of(double x) {
  const double square = x * x;
  assert(square < 0x1.0001p60);
  constexpr double one_word = 0x1p16;
  if (square < one_word) {
    const double scaled = square * 0x1p46;
    const auto whole = std::int64_t(scaled);
    units_ += std::uint64_t(whole + (double(whole) < scaled));
    return;
  }
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

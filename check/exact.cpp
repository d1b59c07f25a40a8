// SPDX-License-Identifier: Apache-2.0
#include "check/exact.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/error.h"

namespace twinray {

Bounded operator/(const Bounded& a, const Bounded& b) {
  const double least = std::fabs(b.value) - b.error;
  if (!(least > 0)) return {0, std::numeric_limits<double>::infinity()};
  const double quotient = a.value / b.value;
  return Bounded::rounded(quotient, (a.error + std::fabs(quotient) * b.error) / least * (1 + 0x1p-48));
}

Bounded square_root(const Bounded& a) {
  const double high = std::sqrt(std::max(a.value + a.error, 0.0)) * (1 + 0x1p-50);
  const double low = std::sqrt(std::max(a.value - a.error, 0.0)) * (1 - 0x1p-50);
  return Bounded::rounded(0.5 * (high + low), 0.5 * (high - low));
}

Exact::Exact(float value) {
  if (!std::isfinite(value))
    throw Error(fmt::format("{} has no exact value; valid is a finite number", value));
  constexpr int digits = std::numeric_limits<float>::digits;
  mantissa_ = long(std::ldexp(std::frexp(value, &exponent_), digits));
  exponent_ -= digits;
}

Exact operator+(const Exact& a, const Exact& b) {
  if (a.sign() == 0) return b;
  if (b.sign() == 0) return a;
  const int exponent = std::min(a.exponent_, b.exponent_);
  return {(a.mantissa_ << (a.exponent_ - exponent)) + (b.mantissa_ << (b.exponent_ - exponent)), exponent};
}

Bounded Exact::bounded() const {
  if (sign() == 0) return {};
  const Integer size = abs(mantissa_);
  const int surplus = std::max(0, int(msb(size)) + 1 - std::numeric_limits<double>::digits);
  const double value = std::ldexp(Integer(size >> surplus).convert_to<double>(), exponent_ + surplus);
  return {mantissa_ < 0 ? -value : value, int(lsb(size)) >= surplus ? 0 : value * 0x1p-52};
}

}  // namespace twinray

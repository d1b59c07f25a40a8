// SPDX-License-Identifier: Apache-2.0
// Private: numbers for deciding signs of polynomials in floats.
//
// A polynomial is written once, as a template over its number type. It is evaluated first with Bounded, a
// double that carries a bound of its own error; where the bound leaves the sign open it is evaluated again
// with Exact, an integer of any length times a power of two (every finite float is one). The idea of
// filtering an exact predicate is that of Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast
// Robust Geometric Predicates", 1997; whole integers take the place of his expansions, because expansions of
// floats from 2^-149 to 2^128 underflow and integers do not.
#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

namespace twinray {

/// A real number known to lie within `error` of `value`. Made from floats, sums and products of up to six
/// factors neither overflow nor underflow.
struct Bounded {
  double value = 0, error = 0;

  Bounded() = default;
  Bounded(float exact) : value(exact) {}
  Bounded(double v, double e) : value(v), error(e) {}

  /// -1, 0 or 1 where it is certain.
  bool has_sign() const { return std::fabs(value) > error || error == 0; }
  int sign() const { return (value > 0) - (value < 0); }
  /// The largest value that it may have in size.
  double most() const { return std::fabs(value) + error; }

  /// The bound of one rounding of v beside inherited errors e; the factor covers the rounding of the sums and
  /// products that make up e itself.
  static Bounded rounded(double v, double e) { return {v, (e + std::fabs(v) * 0x1p-53) * (1 + 0x1p-48)}; }

  friend Bounded operator-(const Bounded& a) { return {-a.value, a.error}; }
  friend Bounded operator+(const Bounded& a, const Bounded& b) {
    return rounded(a.value + b.value, a.error + b.error);
  }
  friend Bounded operator-(const Bounded& a, const Bounded& b) { return a + -b; }
  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    return rounded(a.value * b.value, std::fabs(a.value) * b.error + a.error * b.most());
  }
};

/// a / b; an infinite error where b may be zero.
Bounded operator/(const Bounded& a, const Bounded& b);
/// The square root; of a number that may be negative, that of its positive part.
Bounded square_root(const Bounded& a);

/// sum of limbs[i] 2^(32 i + exponent), negated where `negative`; exact, of any size.
class Exact {
 public:
  Exact() = default;
  Exact(float value);

  int sign() const { return limbs_.empty() ? 0 : negative_ ? -1 : 1; }
  /// The nearest double but for two roundings.
  Bounded bounded() const;

  friend Exact operator-(Exact a);
  friend Exact operator+(const Exact& a, const Exact& b);
  friend Exact operator-(const Exact& a, const Exact& b) { return a + -b; }
  friend Exact operator*(const Exact& a, const Exact& b);

 private:
  using Limbs = std::vector<std::uint32_t>;
  Limbs shifted(int bits) const;
  void trim();

  Limbs limbs_;  ///< Least significant first; the last is not 0; empty for zero.
  int exponent_ = 0;
  bool negative_ = false;
};

}  // namespace twinray

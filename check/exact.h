// SPDX-License-Identifier: Apache-2.0
// Private: numbers that decide the signs of polynomials in floats.
//
// A polynomial is written once, as a template over its number type. It is evaluated first with Bounded, a
// double that carries a bound of its own error; where the bound leaves the sign open it is evaluated again
// with Exact, an integer of any length times a power of two (every finite float is one). The idea of
// filtering an exact predicate is that of Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast
// Robust Geometric Predicates", 1997; Boost's integers take the place of his expansions, because expansions
// of floats from 2^-149 to 2^128 underflow and integers do not.
#pragma once
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

namespace twinray {

/// A real number known to lie within `error` of `value`. Made from floats, sums and products of up to six
/// factors neither overflow nor underflow. Made from NaN or infinity, its sign is not certain.
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

/// mantissa 2^exponent; exact, of any size.
class Exact {
 public:
  Exact() = default;
  /// Throws Error for NaN and infinity.
  Exact(float value);

  /// -1, 0 or 1.
  int sign() const { return mantissa_.sign(); }
  /// A double within 2^-52 of itself; the number itself where 53 bits hold it.
  Bounded bounded() const;

  friend Exact operator-(const Exact& a) { return {-a.mantissa_, a.exponent_}; }
  friend Exact operator+(const Exact& a, const Exact& b);
  friend Exact operator-(const Exact& a, const Exact& b) { return a + -b; }
  friend Exact operator*(const Exact& a, const Exact& b) {
    return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_};
  }

 private:
  /// 512 bits stand in the number itself: enough where the operands' sizes are alike, so that few allocate.
  using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<512>,
                                                boost::multiprecision::et_off>;

  Exact(Integer mantissa, int exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {}

  Integer mantissa_ = 0;
  int exponent_ = 0;
};

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Argument reductions that are exact, or carry their rounding along, then power series cut where the next
// term no longer shows. pow needs log2 to more than double: it is kept as an unevaluated sum of two doubles,
// made with Dekker's exact products ("A floating-point technique for extending the available precision",
// 1971).
#include "core/elementary.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace twinray {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The unevaluated sum high + low, |low| small against |high|.
struct Sum2 {
  double high, low;
};

/// a + b exactly, for |a| >= |b| or a = 0.
Sum2 exact_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a's upper 26 bits, and the rest.
Sum2 halves(double a) {
  const double scaled = 134217729.0 * a;  // 2^27 + 1
  const double high = scaled - (scaled - a);
  return {high, a - high};
}

/// a * b exactly, if nothing overflows or becomes denormal.
Sum2 exact_product(double a, double b) {
  const double product = a * b;
  const Sum2 p = halves(a), q = halves(b);
  return {product, ((p.high * q.high - product) + p.high * q.low + p.low * q.high) + p.low * q.low};
}

/// 2^n for n in [-1022, 1023].
double power_of_two(int n) { return std::bit_cast<double>(std::uint64_t(n + 1023) << 52); }

/// An angle less a whole number of right angles: x = quadrant pi / 2 + rest, |rest| <= pi / 4.
struct Reduced {
  int quadrant;  ///< Modulo 4.
  double rest;
};

Reduced reduce(double x) {
  // pi / 2 as 38 + 38 + 53 bits: up to 2^14 quadrants, the first two products are exact.
  constexpr double first = 0x1.921fb54440000p+0, second = 0x1.68c234c4c0000p-39,
                   third = 0x1.98a2e03707345p-77;
  constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
  const double quadrants = std::floor(x * two_over_pi + 0.5);
  const double rest = ((x - quadrants * first) - quadrants * second) - quadrants * third;
  return {int(quadrants) & 3, rest};
}

double sin_series(double x) {
  const double z = x * x;
  const double series =
      -1.0 / 6 +
      z * (1.0 / 120 +
           z * (-1.0 / 5040 + z * (1.0 / 362880 + z * (-1.0 / 39916800 +
                                                       z * (1.0 / 6227020800 + z * (-1.0 / 1307674368000 +
                                                                                    z / 355687428096000))))));
  return x + x * z * series;
}

double cos_series(double x) {
  const double z = x * x;
  const double series =
      1.0 / 24 +
      z * (-1.0 / 720 +
           z * (1.0 / 40320 + z * (-1.0 / 3628800 +
                                   z * (1.0 / 479001600 + z * (-1.0 / 87178291200 + z / 20922789888000)))));
  // 1 - z / 2 with its rounding, which is larger than all that follows.
  const Sum2 start = exact_sum(1, -0.5 * z);
  return start.high + (start.low + z * z * series);
}

/// Sine of x plus a number of right angles; x in the domain.
double sin_shifted(double x, int right_angles) {
  if (!(std::fabs(x) <= 1e4)) return nan;
  const Reduced r = reduce(x);
  const int quadrant = (r.quadrant + right_angles) & 3;
  const double value = quadrant & 1 ? cos_series(r.rest) : sin_series(r.rest);
  return quadrant & 2 ? -value : value;
}

/// atan(x) / (2 pi) for x in [0, 1], from its power series around 0 or, by the addition theorem, around 1/4,
/// 1/2, 3/4 or 1: the argument of the series is at most 1/8.
double atan_turns(double x) {
  constexpr double atan_of_quarters[] = {0, 0.24497866312686415, 0.46364760900080612, 0.64350110879328439,
                                         0.78539816339744831};
  const int nearest = int(4 * x + 0.5);
  const double center = 0.25 * nearest;
  const double t = (x - center) / (1 + x * center);
  const double z = t * t;
  double series = 1.0 / 17;
  for (int odd = 15; odd >= 1; odd -= 2) series = 1.0 / odd - z * series;
  return (atan_of_quarters[nearest] + t * series) * turns_per_radian;
}

/// log2 of a finite x > 0 to about 2^-57 of itself.
Sum2 log2_wide(double x) {
  constexpr double smallest_normal = std::numeric_limits<double>::min();
  int exponent = 0;
  if (x < smallest_normal) {
    x *= 0x1p64;
    exponent = -64;
  }
  // x = m 2^exponent with m in [sqrt(1/2), sqrt(2)), up to the rounding of the root.
  constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcdu;
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t shift = (bits - root_half) & 0xfff0000000000000u;
  exponent += int(std::int64_t(shift) >> 52);
  const double m = std::bit_cast<double>(bits - shift);

  // log(m) = 2 atanh(s) = 2 (s + s^3 / 3 + s^5 / 5 + ...), s = (m - 1) / (m + 1), |s| < 0.172.
  const double numerator = m - 1;  // Exact.
  const Sum2 denominator = exact_sum(m < 1 ? 1 : m, m < 1 ? m : 1);
  const double s = numerator / denominator.high;
  const Sum2 back = exact_product(s, denominator.high);
  const double s_low = ((numerator - back.high) - back.low - s * denominator.low) / denominator.high;
  const double z = s * s;
  double series = 1.0 / 23;
  for (int odd = 21; odd >= 3; odd -= 2) series = series * z + 1.0 / odd;
  const double tail = s * z * series;

  constexpr double high = 0x1.71547652b82fep+1, low = 0x1.777d0ffda0d24p-55;  // 2 / ln 2
  const Sum2 product = exact_product(s, high);
  const Sum2 fraction = exact_sum(product.high, product.low + s * low + high * (s_low + tail));
  if (exponent == 0) return fraction;
  const Sum2 whole = exact_sum(double(exponent), fraction.high);
  return exact_sum(whole.high, whole.low + fraction.low);
}

/// 2^(x.high + x.low).
double exp2_wide(Sum2 x) {
  if (!(x.high < 1025)) return x.high >= 1025 ? infinity : nan;
  if (x.high < -1080) return 0;
  const double whole = std::floor(x.high + 0.5);
  const double t = ((x.high - whole) + x.low) * 0x1.62e42fefa39efp-1;  // ln 2
  // e^t, |t| < 0.347: the terms from the second on are below a fifth of the first two.
  double series = 1.0 / 6227020800;
  constexpr double factorials[] = {479001600, 39916800, 3628800, 362880, 40320, 5040, 720, 120, 24, 6, 2};
  for (const double factorial : factorials) series = series * t + 1 / factorial;
  const Sum2 start = exact_sum(1, t);
  const double value = start.high + (start.low + t * t * series);
  // In two steps, since 2^whole itself may lie beyond the normal numbers.
  const int first = int(whole) / 2;
  return value * power_of_two(first) * power_of_two(int(whole) - first);
}

}  // namespace

double sin_radians(double x) { return sin_shifted(x, 0); }

double cos_radians(double x) { return sin_shifted(x, 1); }

double tan_radians(double x) { return sin_radians(x) / cos_radians(x); }

double atan2_turns(double y, double x) {
  const double ax = std::fabs(x), ay = std::fabs(y);
  if (ax == 0 && ay == 0) return 0;
  const double eighth = ay <= ax ? atan_turns(ay / ax) : 0.25 - atan_turns(ax / ay);
  const double half = x < 0 ? 0.5 - eighth : eighth;
  return y < 0 ? 1 - half : half;
}

double log2_of(double x) {
  if (!(x > 0)) return x == 0 ? -infinity : nan;
  if (x == infinity) return infinity;
  const Sum2 log = log2_wide(x);
  return log.high + log.low;
}

double exp2_of(double x) { return exp2_wide({x, 0}); }

double pow_of(double x, double y) {
  if (!(x >= 0) || std::isnan(y)) return nan;
  if (y == 0 || x == 1) return 1;
  if (x == 0) return y > 0 ? 0 : infinity;
  const Sum2 log = log2_wide(x);
  const double estimate = y * log.high;
  if (!(std::fabs(estimate) < 1100)) return estimate > 0 ? infinity : 0;
  const Sum2 product = exact_product(y, log.high);
  return exp2_wide({product.high, product.low + y * log.low});
}

}  // namespace twinray

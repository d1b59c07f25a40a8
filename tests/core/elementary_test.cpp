// SPDX-License-Identifier: Apache-2.0
// Every error that core/elementary.h states, against the library's long double (64 bits of mantissa).
#include "core/elementary.h"

#include <cmath>
#include <limits>
#include <utility>

#include "tests/support/catch.h"
#include "tests/support/random.h"

namespace twinray {
namespace {

constexpr long double two_pi = 6.28318530717958647692528676655900577L;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int sweep = 300000;

/// Uniform in [low, high) with 53 bits.
double uniform(test::Random& random, double low, double high) {
  return low + (high - low) * (double(random.bits() >> 11) * 0x1p-53);
}

/// The largest relative error seen.
struct Worst {
  double error = 0;
  void see(double value, long double exact) {
    const long double difference = std::fabs((value - exact) / exact);
    if (!(difference <= error)) error = double(difference);  // A NaN stays.
  }
};

/// All over the domain, around zero, and close to multiples of a right angle.
double angle(test::Random& random, int i) {
  if (i % 3 == 0) return uniform(random, -1e4, 1e4);
  if (i % 3 == 1) return uniform(random, -7, 7);
  const int quarters = random.between(-6000, 6000);
  const int power = random.between(-50, -1);
  return quarters * 1.5707963267948966 + std::ldexp(uniform(random, -1, 1), power);
}

/// Positive numbers of every size, and close to 1.
double positive(test::Random& random, int i) {
  if (i % 3 == 0) {
    const int power = random.between(-1070, 1020);
    return std::ldexp(uniform(random, 0.5, 1), power);
  }
  if (i % 3 == 1) return uniform(random, 0.3, 3);
  const int power = random.between(-51, -1);
  return 1 + std::ldexp(uniform(random, -1, 1), power);
}

}  // namespace

TEST_CASE("sine and cosine of turns are within 2^-23") {
  constexpr int stride = 31;
  double worst = 0;
  for (int i = 0; i <= 1 << 24; i += stride) {
    const float turns = float(i) * 0x1p-24f;
    const SinCos value = sincos_turns(turns);
    const double sine = double(std::fabs(value.sin - std::sin(two_pi * turns)));
    const double cosine = double(std::fabs(value.cos - std::cos(two_pi * turns)));
    worst = std::max({worst, sine, cosine});
  }
  CHECK(worst < 0x1p-23);
}

TEST_CASE("small turns keep their relative precision") {
  for (const float turns : {1e-10f, 1e-20f, 1e-30f})
    CHECK(sincos_turns(turns).sin == Approx(double(two_pi) * turns).epsilon(2e-7));
}

TEST_CASE("quarter turns are exact") {
  const SinCos expected[] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}, {0, 1}};
  for (int i = 0; i <= 4; ++i) {
    const SinCos value = sincos_turns(0.25f * float(i));
    CHECK(value.sin == expected[i].sin);
    CHECK(value.cos == expected[i].cos);
    CHECK_FALSE((value.sin == 0 && std::signbit(value.sin)));
    CHECK_FALSE((value.cos == 0 && std::signbit(value.cos)));
  }
}

TEST_CASE("exp, log and erfc in float are within their stated errors") {
  Worst exp, log, log2;
  double erfc = 0;
  for (int i = 0; i <= sweep; ++i) {
    const float part = float(i) / sweep;
    const float power = -87 + 175 * part;
    exp.see(exp_of(power), std::exp((long double)power));
    const float x = exp_of(power), close_to_1 = 0.5f + part;
    for (const float of : {x, close_to_1}) {
      if (of == 1) continue;
      log.see(log_of(of), std::log((long double)of));
      log2.see(short_log2_of(of), std::log2((long double)of));
    }
    const float distance = 10 * part;
    erfc = std::max(erfc, double(std::fabs(erfc_of(distance) - std::erfc((long double)distance))));
  }
  CHECK(exp.error < 0x1p-22);
  CHECK(log.error < 0x1p-21);
  CHECK(log2.error < 0x1p-21);
  CHECK(erfc < 0x1p-21);
  CHECK(exp_of(0) == 1);
  CHECK(exp_of(-88) == 0);
  CHECK(exp_of(NAN) == 0);
  CHECK(exp_of(1e30f) == exp_of(88));
  CHECK(log_of(1) == 0);
  for (int power = -126; power < 128; ++power) CHECK(short_log2_of(std::ldexp(1.0f, power)) == float(power));
  CHECK(erfc_of(1e10f) == 0);
}

TEST_CASE("sine, cosine and tangent are within their stated errors") {
  test::Random random(11);
  Worst sine, cosine, tangent;
  for (int i = 0; i < sweep; ++i) {
    const double x = angle(random, i);
    if (x == 0) continue;
    sine.see(sin_radians(x), std::sin((long double)x));
    cosine.see(cos_radians(x), std::cos((long double)x));
    tangent.see(tan_radians(x), std::tan((long double)x));
  }
  CHECK(sine.error < 4e-16);
  CHECK(cosine.error < 4e-16);
  CHECK(tangent.error < 8e-16);
}

TEST_CASE("angles outside the domain give NaN") {
  for (const double x : {1.1e4, -1.1e4, infinity, double(NAN)}) {
    CHECK(std::isnan(sin_radians(x)));
    CHECK(std::isnan(cos_radians(x)));
    CHECK(std::isnan(tan_radians(x)));
  }
  CHECK(sin_radians(0) == 0);
  CHECK(cos_radians(0) == 1);
  CHECK(tan_radians(0) == 0);
}

TEST_CASE("the angle of a point is within 2e-16 turns, in every quadrant") {
  test::Random random(12);
  double worst = 0;
  for (int i = 0; i < sweep; ++i) {
    // All around, and close to the axes.
    const int power = i % 2 == 0 ? 0 : random.between(-50, 0);
    const double x = uniform(random, -1, 1), y = std::ldexp(uniform(random, -1, 1), power);
    for (const auto& [a, b] : {std::pair(y, x), {x, y}}) {
      const long double exact = std::atan2(static_cast<long double>(a), static_cast<long double>(b)) / two_pi;
      const long double difference = std::fabs(atan2_turns(a, b) - (exact < 0 ? exact + 1 : exact));
      if (!(difference <= worst)) worst = double(difference);
    }
  }
  CHECK(worst < 2e-16);
  CHECK(atan2_turns(0, 0) == 0);
}

TEST_CASE("log2, exp2 and pow are within their stated errors") {
  test::Random random(13);
  Worst log, exp, pow;
  for (int i = 0; i < sweep; ++i) {
    const double x = positive(random, i);
    const double power = i % 2 == 0 ? uniform(random, -1000, 1000) : uniform(random, -2, 2);
    exp.see(exp2_of(power), std::exp2((long double)power));
    if (x == 1) continue;
    const long double logarithm = std::log2((long double)x);
    log.see(log2_of(x), logarithm);
    const double y = i % 7 == 0 ? 2.4 : double(power / logarithm);
    if (std::fabs(y * logarithm) <= 1000) pow.see(pow_of(x, y), std::pow((long double)x, (long double)y));
  }
  CHECK(log.error < 2e-16);
  CHECK(exp.error < 2e-16);
  CHECK(pow.error < 8e-15);
}

TEST_CASE("powers of two are exact") {
  for (int n = -1074; n <= 1023; ++n) {
    CAPTURE(n);
    CHECK(log2_of(std::ldexp(1.0, n)) == n);
    CHECK(exp2_of(n) == std::ldexp(1.0, n));
    CHECK(pow_of(2, n) == std::ldexp(1.0, n));
  }
}

TEST_CASE("logarithms and powers at the ends of their domains") {
  CHECK(log2_of(0) == -infinity);
  CHECK(log2_of(infinity) == infinity);
  CHECK(std::isnan(log2_of(-1)));
  CHECK(std::isnan(log2_of(NAN)));
  CHECK(exp2_of(1e300) == infinity);
  CHECK(exp2_of(1024) == infinity);
  CHECK(exp2_of(-1100) == 0);
  CHECK(exp2_of(-1e300) == 0);
  CHECK(std::isnan(exp2_of(NAN)));
  CHECK(pow_of(0, 0) == 1);
  CHECK(pow_of(0, 2.5) == 0);
  CHECK(pow_of(0, -1) == infinity);
  CHECK(pow_of(1, 1e300) == 1);
  CHECK(pow_of(7, 0) == 1);
  CHECK(pow_of(2, 1e308) == infinity);
  CHECK(pow_of(0.5, 1e308) == 0);
  CHECK(pow_of(1 + 0x1p-52, -1e300) == 0);
  CHECK(std::isnan(pow_of(-2, 2)));
  CHECK(std::isnan(pow_of(2, NAN)));
}

}  // namespace twinray

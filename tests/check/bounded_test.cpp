// SPDX-License-Identifier: Apache-2.0
// The numbers of the judge's filter: whatever is computed with them, the true result lies within the error.
#include <cmath>

#include "check/exact.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"

namespace twinray {
namespace {

using test::Random;

/// Truth here has the 64 bits of a long double: what it is off by is far below what a double can be.
constexpr long double rounding_of_truth = 0x1p-61L;

bool holds(const Bounded& number, long double truth) {
  return std::fabs((long double)number.value - truth) <=
         (long double)number.error + std::fabs(truth) * rounding_of_truth;
}

/// A number and its two ends, which are doubles too: its error is a power of two, from none or the last bit
/// of the number up to half of it.
struct Uncertain {
  Bounded number;
  double low, high;
};

Uncertain uncertain(Random& random) {
  const double sign = random.below(2) ? 1 : -1;
  const int exponent = random.between(-60, 60);
  const double value = sign * std::ldexp(1 + double(random.unit()), exponent);
  constexpr int exponents[] = {-52, -40, -20, -2, -1};
  const int kind = random.below(6);
  const double error = kind == 5 ? 0 : std::ldexp(1.0, exponent + exponents[kind]);
  return {{value, error}, value - error, value + error};
}

}  // namespace

TEST_CASE("a quotient's error holds every quotient of what its two numbers may be") {
  Random random(11);
  for (int i = 0; i < 100000; ++i) {
    const Uncertain a = uncertain(random), b = uncertain(random);
    const Bounded quotient = a.number / b.number;
    INFO("draw " << i << ": " << a.number.value << " +- " << a.number.error << " / " << b.number.value
                 << " +- " << b.number.error);
    for (const double dividend : {a.low, a.high})
      for (const double divisor : {b.low, b.high})
        REQUIRE(holds(quotient, (long double)dividend / (long double)divisor));
  }
}

TEST_CASE("a quotient of exact numbers is known to its last bit, and of nothing is not known") {
  Random random(12);
  for (int i = 0; i < 10000; ++i) {
    const Bounded a(random.uniform(1, 2)), b(random.uniform(1, 2));
    REQUIRE((a / b).error <= 0x1.001p-53 * (a / b).value);
  }
  CHECK(std::isinf((Bounded(1.0f) / Bounded(0.0f)).error));
  CHECK(std::isinf((Bounded(1.0f) / Bounded(1.0, 1.0)).error));
  CHECK_FALSE((Bounded(1.0f) / Bounded(0.5, 1.0)).has_sign());
}

TEST_CASE("a square root's error holds the root of all that its number may be") {
  Random random(13);
  for (int i = 0; i < 100000; ++i) {
    const Uncertain a = uncertain(random);
    const Bounded root = square_root(a.number);
    INFO("draw " << i << ": " << a.number.value << " +- " << a.number.error);
    for (const double square : {a.low, a.high})
      if (square >= 0) REQUIRE(holds(root, std::sqrt((long double)square)));
  }
  CHECK(square_root(Bounded(-1.0, 1.5)).value >= 0);
  CHECK(square_root(Bounded(4.0f)).error <= 0x1p-48);
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "check/exact.h"

#include <cmath>
#include <limits>

#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"
#include "tests/support/wide_integer.h"

namespace twinray {
namespace {

using test::Random;
using test::sign;
using test::Wide;

}  // namespace

TEST_CASE("exact numbers add, subtract and multiply as integers do") {
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const int p = random.between(-0xffffff, 0xffffff), q = random.between(-0xffffff, 0xffffff);
    const int r = random.between(-300, 300), s = random.between(-0xffffff, 0xffffff);
    const Exact value =
        (Exact(float(p)) * Exact(float(q)) - Exact(float(r)) * Exact(float(s))) * Exact(float(q));
    const Wide expected = (Wide(p) * q - Wide(r) * s) * q;
    INFO("p " << p << " q " << q << " r " << r << " s " << s);
    CHECK(value.sign() == sign(expected));
    const Bounded rounded = value.bounded();
    CHECK(std::fabs(rounded.value - double(expected)) <=
          rounded.error + std::fabs(double(expected)) * 0x1p-52);
  }
}

TEST_CASE("exact numbers keep the least bit of a float beside the greatest float") {
  const Exact huge(0x1.fffffep127f), tiny(0x1p-149f);
  CHECK((huge + tiny - huge - tiny).sign() == 0);
  CHECK((huge + tiny - huge).sign() == 1);
  CHECK((huge + tiny - huge).bounded().value == 0x1p-149);
  const Exact product = (huge + tiny) * (huge - tiny);
  CHECK((product - huge * huge + tiny * tiny).sign() == 0);
  CHECK((product - huge * huge).sign() == -1);
}

TEST_CASE("a bounded number's interval holds the exact result") {
  Random random(2);
  for (int i = 0; i < 20000; ++i) {
    const float a = std::ldexp(random.uniform(-1, 1), random.between(-40, 40));
    const float b = std::ldexp(random.uniform(-1, 1), random.between(-40, 40));
    const float c = random.uniform(-1, 1);
    const Bounded filtered = (Bounded(a) + b) * (Bounded(c) - b) * a - Bounded(b) * b;
    const Exact exact = (Exact(a) + b) * (Exact(c) - b) * a - Exact(b) * b;
    const Bounded truth = exact.bounded();
    CHECK(std::fabs(filtered.value - truth.value) <= filtered.error + truth.error);
    if (filtered.has_sign()) CHECK(filtered.sign() == exact.sign());
  }
}

TEST_CASE("exact numbers have no NaN and no infinity") {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const float value : {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity}) {
    INFO(value);
    CHECK_THROWS_AS(Exact(value), Error);
    const Bounded filtered = (Bounded(value) - Bounded(1)) * Bounded(2);
    CHECK_FALSE(filtered.has_sign());
  }
  CHECK_THROWS_WITH(Exact(infinity), "inf has no exact value; valid is a finite number");
}

TEST_CASE("an exact number's double is the number itself up to 53 bits, and within 2^-52 beyond") {
  const Exact one(1), ulp(0x1p-52f), half_ulp(0x1p-53f), zero(0);
  CHECK((one + ulp).bounded().value == 1 + 0x1p-52);
  CHECK((one + ulp).bounded().error == 0);
  for (const Exact& sum : {one + half_ulp, -(one + half_ulp)}) {
    const Bounded rounded = sum.bounded();
    CHECK(rounded.error == 0x1p-52 * std::fabs(rounded.value));
    CHECK(std::fabs(std::fabs(rounded.value) - 1) <= rounded.error);
    CHECK(sum.sign() == (rounded.value > 0 ? 1 : -1));
  }
  CHECK(zero.bounded().value == 0);
  CHECK(zero.bounded().error == 0);
}

}  // namespace twinray

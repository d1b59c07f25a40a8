// SPDX-License-Identifier: Apache-2.0
#include "core/exact_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "tests/support/catch.h"
#include "tests/support/random.h"

namespace twinray {

TEST_CASE("parts in floats give the whole to the last bit, added up in any order, and hardly change") {
  test::Random random(8);
  for (int trial = 0; trial < 20000; ++trial) {
    std::vector<float> given(8);
    for (float& part : given)
      part = random.below(3) == 0 ? 0 : random.unit() * std::ldexp(1.0f, random.between(-30, 20));
    const float whole = float(std::accumulate(given.begin(), given.end(), 0.0));
    std::vector<float> parts = given;
    make_exact(whole, parts);
    const float last_bit = std::nextafter(whole, std::numeric_limits<float>::infinity()) - whole;
    const auto largest = std::max_element(given.begin(), given.end()) - given.begin();
    for (std::size_t i = 0; i < parts.size(); ++i) {
      REQUIRE(parts[i] >= 0);
      REQUIRE(std::fabs(parts[i] - given[i]) <= (std::ptrdiff_t(i) == largest ? 5.0f : 0.5f) * last_bit);
    }
    for (int order = 0; order < 4; ++order) {
      REQUIRE(std::accumulate(parts.begin(), parts.end(), 0.0f) == whole);
      for (std::size_t i = parts.size(); i-- > 1;)
        std::swap(parts[i], parts[random.below(std::uint32_t(i + 1))]);
    }
  }
}

TEST_CASE("the parts of nothing are nothing") {
  std::vector<float> parts{1e-20f, 0, 1e-30f};
  make_exact(0.0f, parts);
  CHECK(parts == std::vector<float>{0, 0, 0});
}

TEST_CASE("negative parts add up as others do") {
  test::Random random(9);
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<float> given(8);
    for (float& part : given) part = random.unit() * std::ldexp(1.0f, random.between(-30, 20));
    const float whole = float(std::accumulate(given.begin(), given.end(), 0.0));
    std::vector<float> parts = given, negative = given;
    for (float& part : negative) part = -part;
    make_exact(whole, parts);
    make_exact(-whole, negative);
    for (std::size_t i = 0; i < parts.size(); ++i) REQUIRE(negative[i] == -parts[i]);
  }
}

TEST_CASE("parts of both signs, and whatever they leave, add up as far as the largest is exact") {
  std::vector<float> parts{0.5f, -0.499f, 1e-4f};
  const float whole = 0.0013f;
  make_exact(whole, parts);
  CHECK(parts[1] == -0.499f);
  CHECK(parts[2] == 1e-4f);
  CHECK(std::fabs(std::accumulate(parts.begin(), parts.end(), 0.0) - double(whole)) <= 0x1p-25);
  std::vector<float> cancelled{0.25f, -0.5f};
  make_exact(0.0f, cancelled);
  CHECK(cancelled[0] + cancelled[1] == 0);
  CHECK(cancelled[0] == 0.25f);
}

}  // namespace twinray

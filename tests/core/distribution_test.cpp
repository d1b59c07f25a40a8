// SPDX-License-Identifier: Apache-2.0
#include "core/distribution.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/chi_square.h"
#include "tests/support/random.h"

namespace twinray {
namespace {

constexpr float just_below_one = 0x1.fffffep-1f;

Distribution make(const std::vector<double>& weights) { return Distribution(weights); }

}  // namespace

TEST_CASE("indices are chosen with their probabilities, and the remainder is uniform") {
  const std::vector<double> weights = {0, 1, 2, 0, 5, 0.25, 3, 0};
  const Distribution distribution(weights);
  constexpr int samples = 200000;
  test::Random random(1);
  std::vector<std::size_t> counts(weights.size());
  test::Grid remainders(64, 1);
  for (int i = 0; i < samples; ++i) {
    const Distribution::Choice choice = distribution.sample(random.unit());
    ++counts[choice.index];
    REQUIRE(choice.remainder >= 0);
    REQUIRE(choice.remainder < 1);
    remainders.add(choice.remainder, 0);
  }
  std::vector<double> expected;
  for (const double weight : weights) expected.push_back(samples * weight / distribution.total());
  test::check_counts(counts, expected, 2, 0.015);
  test::check_uniform(remainders.counts(), 2, 0.025);
}

TEST_CASE("the index of a draw is the first whose sum is above it, however the weights differ") {
  test::Random random(7);
  for (const std::size_t size : {1, 3, 7, 8, 63, 64, 1000, 4097})
    for (const double power : {0.0, 1.0, 30.0}) {
      CAPTURE(size, power);
      std::vector<double> weights(size), sums{0};
      for (double& weight : weights) weight = random.unit() < 0.5 ? 0 : std::pow(random.unit(), power);
      weights[size / 2] = 1;
      for (const double weight : weights) sums.push_back(sums.back() + weight);
      const Distribution distribution(weights);
      std::vector<float> draws{0, 0.25f, 0.5f, just_below_one};
      while (draws.size() < 2000) draws.push_back(random.unit());
      for (const float u : draws) {
        const auto above = std::upper_bound(sums.begin(), sums.end(), double(u) * sums.back());
        REQUIRE(distribution.sample(u).index == std::size_t(above - sums.begin()) - 1);
      }
    }
}

TEST_CASE("indices of many distributions are chosen together as each is alone") {
  test::Random random(4);
  std::vector<Distribution> distributions;
  for (std::size_t size = 1; size <= Distribution::most_together; ++size) {
    std::vector<double> weights(size * size % 97 + 1);
    for (double& weight : weights) weight = random.unit() < 0.3 ? 0 : random.unit();
    weights[weights.size() / 2] = 0.5;
    distributions.push_back(make(weights));
  }
  for (const std::size_t count : {std::size_t(0), std::size_t(1), std::size_t(17), distributions.size()})
    for (int repeat = 0; repeat < 100; ++repeat) {
      std::vector<const Distribution*> of;
      std::vector<float> draws;
      for (std::size_t i = 0; i < count; ++i) {
        of.push_back(&distributions[i]);
        draws.push_back(repeat == 0 ? 0 : repeat == 1 ? just_below_one : random.unit());
      }
      std::vector<Distribution::Choice> choices(count);
      Distribution::sample(of, draws, choices);
      for (std::size_t i = 0; i < count; ++i) {
        CHECK(choices[i].index == of[i]->sample(draws[i]).index);
        CHECK(choices[i].remainder == of[i]->sample(draws[i]).remainder);
      }
    }
}

TEST_CASE("probabilities are weights over their total") {
  const Distribution distribution = make({1, 0, 3, 4});
  CHECK(distribution.total() == 8);
  CHECK(distribution.size() == 4);
  CHECK(distribution.probability(0) == 0.125f);
  CHECK(distribution.probability(1) == 0);
  CHECK(distribution.probability(2) == 0.375f);
  CHECK(distribution.probability(3) == 0.5f);
}

TEST_CASE("the remainder says where in its index a draw fell") {
  const Distribution distribution = make({1, 3});
  CHECK(distribution.sample(0).index == 0);
  CHECK(distribution.sample(0.125f).remainder == 0.5f);
  CHECK(distribution.sample(0.25f).index == 1);
  CHECK(distribution.sample(0.25f).remainder == 0);
  CHECK(distribution.sample(0.625f).remainder == 0.5f);
}

TEST_CASE("a weight of zero is never chosen, at the ends of the range either") {
  const std::vector<std::vector<double>> cases = {
      {0, 1, 0}, {0, 0, 5e-324, 0, 0}, {0, 1e300, 0, 1e-300, 0}, {0, 1e-320, 0, 0}, {0, 0.1, 0.7, 0.2, 0}};
  for (const auto& weights : cases) {
    const Distribution distribution(weights);
    for (const float u : {0.0f, 0x1p-149f, 0x1p-24f, 0.3f, 0.5f, 0x1.fffffcp-1f, just_below_one}) {
      CAPTURE(weights, u);
      const Distribution::Choice choice = distribution.sample(u);
      REQUIRE(choice.index < weights.size());
      CHECK(weights[choice.index] > 0);
      CHECK(distribution.probability(choice.index) > 0);
      CHECK(choice.remainder >= 0);
      CHECK(choice.remainder < 1);
    }
  }
}

TEST_CASE("a probability too small for a float can still be divided by") {
  const Distribution distribution = make({1e-60, 1});
  CHECK(distribution.sample(0).index == 0);
  CHECK(distribution.probability(0) == std::numeric_limits<float>::min());
}

TEST_CASE("without weight the total is zero") {
  CHECK(Distribution().total() == 0);
  CHECK(make({}).total() == 0);
  CHECK(make({0, 0}).total() == 0);
  CHECK(make({0, 0}).size() == 2);
}

TEST_CASE("weights that are negative or not finite are refused") {
  CHECK_THROWS_WITH(make({1, -2}),
                    "weight 1 of a distribution is -2 after a sum of 1: all must be finite and >= 0");
  CHECK_THROWS_WITH(make({NAN}),
                    "weight 0 of a distribution is nan after a sum of 0: all must be finite and >= 0");
  CHECK_THROWS_AS(make({INFINITY}), Error);
  CHECK_THROWS_AS(make({1e308, 1e308}), Error);
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// The statistical helpers themselves: they accept what is right and reject what is wrong.
#include "tests/support/statistics.h"

#include <array>
#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/chi_square.h"
#include "tests/support/random.h"

namespace twinray::test {

TEST_CASE("the p-value of chi-square agrees with its closed form for even degrees") {
  // Q(n, x) = e^-x (1 + x + ... + x^(n - 1) / (n - 1)!).
  constexpr double tolerance = 1e-10;
  for (const int degrees : {2, 4, 10, 60, 200})
    for (const double statistic : {0.1, 1.0, 5.0, 20.0, 60.0, 150.0, 300.0}) {
      CAPTURE(degrees, statistic);
      const double x = statistic / 2;
      double term = 1, sum = 1;
      for (int n = 1; n < degrees / 2; ++n) sum += term *= x / n;
      CHECK(chi_square_p_value(statistic, degrees) == Approx(std::exp(-x) * sum).epsilon(tolerance));
    }
}

TEST_CASE("the p-value of chi-square agrees with the normal distribution for one degree") {
  constexpr double tolerance = 1e-10;
  for (const double z : {0.1, 1.0, 1.959964, 3.0, 8.0})
    CHECK(chi_square_p_value(z * z, 1) == Approx(std::erfc(z / std::sqrt(2.0))).epsilon(tolerance));
}

TEST_CASE("chi-square of hand-made counts") {
  const std::array<std::size_t, 3> observed = {8, 12, 10};
  const ChiSquare result = chi_square_uniform(observed);
  CHECK(result.statistic == Approx(0.8));
  CHECK(result.degrees == 2);
  CHECK(result.p_value == Approx(std::exp(-0.4)));
}

TEST_CASE("bins that expect fewer than five are pooled") {
  const std::array<std::size_t, 6> observed = {1, 20, 3, 2, 24, 0};
  const std::array<double, 6> expected = {2, 20, 2, 2, 24, 0};
  const ChiSquare result = chi_square(observed, expected);
  CHECK(result.degrees == 2);
  CHECK(result.statistic == Approx(0));
}

TEST_CASE("what expects too little for a pool of its own joins another") {
  const std::array<std::size_t, 2> observed = {0, 100};
  const std::array<double, 2> expected = {1, 99};
  CHECK(chi_square(observed, expected).degrees == 0);
}

TEST_CASE("a count where none is expected is never accepted") {
  const std::array<std::size_t, 3> observed = {1, 500, 500};
  const std::array<double, 3> expected = {0, 500, 501};
  CHECK(chi_square(observed, expected).p_value == 0);
}

TEST_CASE("chi-square accepts uniform numbers and rejects slightly uneven ones") {
  Random random(1);
  Grid uniform(8, 8), uneven(8, 8);
  for (int i = 0; i < 200000; ++i) {
    const double x = random.unit(), y = random.unit();
    uniform.add(x, y);
    uneven.add(x * (0.9 + 0.1 * x), y);
  }
  CHECK(chi_square_uniform(uniform.counts()).p_value > sidak_level(1));
  CHECK(chi_square_uniform(uneven.counts()).p_value < 1e-9);
}

TEST_CASE("Sidak's levels multiply to the family's") {
  CHECK(sidak_level(1, 0.05) == Approx(0.05));
  CHECK(1 - std::pow(1 - sidak_level(20, 0.05), 20) == Approx(0.05));
}

TEST_CASE("the z-test knows the usual quantiles, and a mean from a wrong one") {
  CHECK(z_test(1 + 2 * 1.959964, 2, 1) == Approx(0.05).epsilon(1e-5));
  CHECK(z_test(1 - 2 * 1.959964, 2, 1) == Approx(0.05).epsilon(1e-5));
  CHECK(z_test(3, 0, 3) == 1);
  CHECK(z_test(3, 0, 3.1) == 0);
  Random random(2);
  SampleMean sample;
  for (int i = 0; i < 100000; ++i) sample.add(random.unit());
  CHECK(sample.variance() == Approx(1.0 / 12).epsilon(0.01));
  CHECK(z_test(sample, 0.5) > sidak_level(1));
  CHECK(z_test(sample, 0.51) < 1e-9);
}

TEST_CASE("the limit of a level is that of the normal distribution") {
  CHECK(z_limit(0.05) == Approx(1.959964).epsilon(1e-6));
  CHECK(z_limit(1e-6) == Approx(4.891638).epsilon(1e-6));
  CHECK(seen_error(2, 0.05) == Approx(2 * (1.959964 + 2.326348)).epsilon(1e-6));
}

TEST_CASE("a deviation that chi-square is said to see is seen 99 times in a hundred") {
  constexpr int bins = 50, samples = 20000, trials = 400;
  const double level = sidak_level(1), deviation = seen_deviation(samples, bins - 1, level);
  Random random(41);
  int seen = 0;
  for (int trial = 0; trial < trials; ++trial) {
    Grid grid(bins, 1);
    for (int i = 0; i < samples; ++i) {
      // Density 1 + deviation on the even bins, 1 - deviation on the odd ones.
      const int pair = random.below(bins / 2);
      const bool is_odd = random.unit() > 0.5 * (1 + deviation);
      grid.add((2 * pair + (is_odd ? 1.5 : 0.5)) / bins, 0);
    }
    seen += chi_square_uniform(grid.counts()).p_value < level;
  }
  CHECK(seen == Approx(0.99 * trials).margin(10));  // five standard deviations
}

}  // namespace twinray::test

// SPDX-License-Identifier: Apache-2.0
#include "check/welch.h"

#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/catch.h"

namespace twinray::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool is_near(double value, double expected) { return std::abs(value - expected) <= 1e-12 * expected; }

MeanEstimate estimate_of(const std::vector<double>& values) {
  double sum = 0, squares = 0;
  for (const double value : values) sum += value;
  const double n = double(values.size()), mean = sum / n;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, squares / (n - 1) / n, n - 1};
}

}  // namespace

TEST_CASE("p-values of Student's distribution are those of another program") {
  struct Known {
    double t, freedom, p;
  };
  // scipy 1.17.1: 2 * scipy.stats.t.sf(abs(t), freedom), and norm.sf for infinity
  for (const Known& known : {Known{0.5, 1, 0.7048327646991335},
                             {2, 3, 0.13932596855884305},
                             {-2.5, 7.5, 0.03882025827362553},
                             {4, 12, 0.0017616962443950267},
                             {10, 30, 4.575251408229618e-11},
                             {1.96, 1e6, 0.04999606758526985},
                             {40, 20, 1.457469655431075e-20},
                             {3, infinity, 0.0026997960632601866}}) {
    CAPTURE(known.t, known.freedom);
    CHECK(is_near(two_sided_p_value(known.t, known.freedom), known.p));
  }
}

TEST_CASE("Welch's test of two samples is that of another program") {
  // scipy.stats.ttest_ind(a, b, equal_var=False)
  const WelchTest test =
      welch_test(estimate_of({2.1, 2.5, 1.9, 2.7, 2.3}), estimate_of({1.2, 1.9, 1.6, 1.1, 1.75, 1.3, 1.45}));
  CHECK(is_near(test.t, 4.60573792787005));
  CHECK(is_near(test.freedom, 8.347488448874042));
  CHECK(is_near(test.p_value, 0.0015589205948300501));
}

TEST_CASE("means that differ by a float's rounding are equal, and exact means that differ by more are not") {
  CHECK(welch_test({0.7}, {0.7}).p_value == 1);
  CHECK(welch_test({0.7}, {0.7 * (1 + 5e-7)}).p_value == 1);
  CHECK(welch_test({0.7}, {0.7 * (1 + 5e-6)}).p_value == 0);
  CHECK(welch_test({0.7}, {0.7 * (1 + 5e-6)}).t == -infinity);
  CHECK(welch_test({0}, {0}).p_value == 1);
}

TEST_CASE("a mean of means has their mean variance over their number, and the freedom of all") {
  MeanOfMeans alike;
  for (int i = 0; i < 10; ++i) alike.add({double(i), 2, 3});
  CHECK(alike.estimate().mean == 4.5);
  CHECK(alike.estimate().variance == Approx(0.2));
  CHECK(alike.estimate().freedom == Approx(30));
  // One that varies alone has its own freedom, whatever certain ones stand beside it.
  MeanOfMeans mixed;
  mixed.add({1, 4, 3});
  mixed.add({3});
  CHECK(mixed.count() == 2);
  CHECK(mixed.estimate().mean == 2);
  CHECK(mixed.estimate().variance == 1);
  CHECK(mixed.estimate().freedom == Approx(3));
  CHECK(MeanOfMeans().estimate().variance == 0);
}

TEST_CASE("the least of many p-values is corrected for their number, tiny ones too") {
  CHECK(corrected_p_value(0.5, 2) == Approx(0.75));
  CHECK(corrected_p_value(0.001, 100) == Approx(0.09520785288));
  CHECK(corrected_p_value(1e-20, 1000) == Approx(1e-17));
  CHECK(corrected_p_value(0.25, 1) == Approx(0.25));
  CHECK(corrected_p_value(1, 7) == 1);
}

}  // namespace twinray::test

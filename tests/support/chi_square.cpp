// SPDX-License-Identifier: Apache-2.0
#include "tests/support/chi_square.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "tests/support/catch.h"
#include "tests/support/statistics.h"

namespace twinray::test {
namespace {

constexpr double least_expected = 5;
constexpr double converged = 1e-16;

/// P(a, x) = x^a e^-x / Gamma(a + 1) (1 + x / (a + 1) + x^2 / ((a + 1)(a + 2)) + ...), quick for x < a + 1.
double lower_gamma_series(double a, double x) {
  double term = 1, sum = 1;
  for (int n = 1; term > sum * converged; ++n) sum += term *= x / (a + n);
  return sum * std::exp(a * std::log(x) - x - std::lgamma(a + 1));
}

/// Q(a, x) = x^a e^-x / Gamma(a) / (x + 1 - a - 1 (1 - a) / (x + 3 - a - 2 (2 - a) / (x + 5 - a - ...))),
/// quick for x > a + 1; evaluated forwards (Lentz 1976).
double upper_gamma_fraction(double a, double x) {
  double b = x + 1 - a, c = 1 / std::numeric_limits<double>::min(), d = 1 / b, value = d;
  for (int n = 1; n < 10000; ++n) {
    const double numerator = -n * (n - a);
    b += 2;
    d = 1 / (b + numerator * d);
    c = b + numerator / c;
    value *= c * d;
    if (std::fabs(c * d - 1) < converged) break;
  }
  return value * std::exp(a * std::log(x) - x - std::lgamma(a));
}

}  // namespace

double chi_square_p_value(double statistic, int degrees) {
  if (degrees <= 0 || statistic <= 0) return 1;
  const double a = 0.5 * degrees, x = 0.5 * statistic;
  return x < a + 1 ? 1 - lower_gamma_series(a, x) : upper_gamma_fraction(a, x);
}

ChiSquare chi_square(std::span<const std::size_t> observed, std::span<const double> expected) {
  std::vector<std::size_t> order(expected.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return expected[a] < expected[b]; });
  ChiSquare result;
  int pools = 0;
  double pool_observed = 0, pool_expected = 0, left = std::accumulate(expected.begin(), expected.end(), 0.0);
  for (const std::size_t bin : order) {
    if (expected[bin] == 0 && observed[bin] > 0) return {.statistic = INFINITY, .degrees = 0, .p_value = 0};
    pool_observed += double(observed[bin]);
    pool_expected += expected[bin];
    left -= expected[bin];
    const bool last = bin == order.back();
    // What would be left over at the end joins this pool.
    if (!last && (pool_expected < least_expected || left < least_expected)) continue;
    result.statistic += (pool_observed - pool_expected) * (pool_observed - pool_expected) / pool_expected;
    ++pools;
    pool_observed = pool_expected = 0;
  }
  result.degrees = pools - 1;
  result.p_value = chi_square_p_value(result.statistic, result.degrees);
  return result;
}

ChiSquare chi_square_uniform(std::span<const std::size_t> observed) {
  const double total = double(std::accumulate(observed.begin(), observed.end(), std::size_t(0)));
  const std::vector<double> expected(observed.size(), total / double(observed.size()));
  return chi_square(observed, expected);
}

double seen_deviation(std::size_t samples, int degrees, double level) {
  constexpr double z_power = 2.326348;
  const auto bisect = [](double most, const auto& is_below) {
    double low = 0, high = most;
    for (int step = 0; step < 100; ++step) {
      const double middle = 0.5 * (low + high);
      (is_below(middle) ? low : high) = middle;
    }
    return high;
  };
  const double k = degrees;
  const double limit =
      bisect(100 * k + 1000, [&](double x) { return chi_square_p_value(x, degrees) > level; });
  const double l =
      bisect(100 * limit, [&](double x) { return k + x - z_power * std::sqrt(2 * (k + 2 * x)) < limit; });
  return std::sqrt(l / double(samples));
}

void check_counts(std::span<const std::size_t> observed, std::span<const double> expected, int tests,
                  double sees) {
  const ChiSquare result = chi_square(observed, expected);
  const double level = sidak_level(tests);
  const std::size_t samples = std::accumulate(observed.begin(), observed.end(), std::size_t(0));
  CAPTURE(result.statistic, result.degrees, level);
  CHECK(result.p_value > level);
  CHECK(seen_deviation(samples, result.degrees, level) <= sees);
}

void check_uniform(std::span<const std::size_t> observed, int tests, double sees) {
  const double total = double(std::accumulate(observed.begin(), observed.end(), std::size_t(0)));
  check_counts(observed, std::vector<double>(observed.size(), total / double(observed.size())), tests, sees);
}

void Grid::add(double x, double y) {
  const int column = std::clamp(int(x * columns_), 0, columns_ - 1);
  const int row = std::clamp(int(y * rows_), 0, rows_ - 1);
  ++counts_[std::size_t(row * columns_ + column)];
}

}  // namespace twinray::test

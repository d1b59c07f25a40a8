// SPDX-License-Identifier: Apache-2.0
// Pearson's test: do counts agree with the numbers expected in each bin?
#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace twinray::test {

struct ChiSquare {
  double statistic = 0;
  int degrees = 0;     ///< Bins after pooling, less one.
  double p_value = 1;  ///< The chance of a statistic at least as large; 0 where the impossible was observed.
};

/// Compares counts with expected counts of the same total. Bins that expect fewer than 5 are pooled, from the
/// smallest on, until each pool expects 5. A count where 0 is expected gives p = 0.
ChiSquare chi_square(std::span<const std::size_t> observed, std::span<const double> expected);

/// Each of the bins expects the same.
ChiSquare chi_square_uniform(std::span<const std::size_t> observed);

/// The smallest relative deviation (root of the mean square, over bins as weighted by their expected counts)
/// of a density that the test sees with a probability of 99 %: from mean k + l and variance 2 (k + 2 l) of a
/// chi-square variable of k degrees whose density is off by sqrt(l / samples).
double seen_deviation(std::size_t samples, int degrees, double level);

/// Checks that counts agree with what is expected, as one of `tests` tests of a family (test::sidak_level),
/// and that a deviation of `sees` would be seen.
void check_counts(std::span<const std::size_t> observed, std::span<const double> expected, int tests,
                  double sees);
/// The same where each of the bins expects the same.
void check_uniform(std::span<const std::size_t> observed, int tests, double sees);

/// P(X >= statistic) of a chi-square variable: the regularised incomplete gamma function Q(degrees / 2,
/// statistic / 2), by its series or its continued fraction. Relative error below 1e-10 where it is above
/// 1e-200.
double chi_square_p_value(double statistic, int degrees);

/// Counts over a grid of `columns` x `rows` cells of the unit square.
class Grid {
 public:
  Grid(int columns, int rows) : columns_(columns), rows_(rows), counts_(std::size_t(columns * rows)) {}
  /// x and y in [0, 1]; 1 belongs to the last cell.
  void add(double x, double y);
  std::span<const std::size_t> counts() const { return counts_; }

 private:
  int columns_, rows_;
  std::vector<std::size_t> counts_;  ///< Row by row.
};

}  // namespace twinray::test

// SPDX-License-Identifier: Apache-2.0
// Whether two means differ by more than their noise (B. L. Welch, "The Generalization of 'Student's' Problem
// when Several Different Population Variances are Involved", 1947).
#pragma once
#include <cstddef>
#include <limits>

namespace twinray {

/// A mean of independent observations, and how well it is known.
struct MeanEstimate {
  double mean = 0;
  double variance = 0;  ///< Of the mean: the variance of one observation over their number.
  /// Degrees of freedom of the variance: observations minus 1; infinity where it is known exactly.
  double freedom = std::numeric_limits<double>::infinity();
};

/// The mean of several independent means that are expected to differ, such as those of a tile's pixels. Its
/// degrees of freedom are F. E. Satterthwaite's (1946).
class MeanOfMeans {
 public:
  void add(const MeanEstimate& one);
  std::size_t count() const { return count_; }
  /// Zeros without any.
  MeanEstimate estimate() const;

 private:
  std::size_t count_ = 0;
  double means_ = 0, variances_ = 0;
  double squares_ = 0;  ///< Of the variances, each over its degrees of freedom.
};

struct WelchTest {
  double t = 0;  ///< The difference of the means, the first minus the second, in standard errors.
  double freedom = std::numeric_limits<double>::infinity();
  /// The chance that two equal means would differ as much, on either side. Small: they are not equal.
  double p_value = 1;
};

/// Means that differ by the rounding of a float are equal. Without any variance p is 1 for equal means, else
/// 0.
WelchTest welch_test(const MeanEstimate& a, const MeanEstimate& b);

/// The chance that a variable of Student's distribution is at least as far from 0 as t.
double two_sided_p_value(double t, double freedom);

/// The chance that the least p-value of so many independent tests would be as small as this one though all
/// means are equal (Sidak's correction).
double corrected_p_value(double least, std::size_t tests);

}  // namespace twinray

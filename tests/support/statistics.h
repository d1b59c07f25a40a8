// SPDX-License-Identifier: Apache-2.0
// Tests of hypotheses with a stated level. Seeds are fixed, so a test passes always or fails always; the
// level is the chance that an honest seed would have failed.
#pragma once
#include <cstddef>

namespace twinray::test {

/// The chance that any test of one family (a test case with several comparisons) fails although all is right.
inline constexpr double family_level = 0.01;

/// Sidak's correction: the level of each of `tests` independent tests, so that one or more of them fail with
/// the probability `family`. Reject what has a smaller p-value.
double sidak_level(int tests, double family = family_level);

/// The number of standard errors beyond which a two-sided z-test rejects at a level.
double z_limit(double level);

/// An error of this size is seen by a z-test with a probability of 99 %. A test that does not say what it
/// would see may see nothing.
double seen_error(double standard_error, double level);

/// Mean and standard error of independent numbers (Welford, 1962).
class SampleMean {
 public:
  void add(double x);
  std::size_t count() const { return count_; }
  double mean() const { return mean_; }
  /// Unbiased; 0 for fewer than two.
  double variance() const;
  /// Of the mean.
  double standard_error() const;

 private:
  std::size_t count_ = 0;
  double mean_ = 0, squares_ = 0;
};

/// The chance that a normal variable of mean `expected` is at least as far from it as `estimate` is, on
/// either side. Without a standard error: 1 if they are equal, else 0.
double z_test(double estimate, double standard_error, double expected);
double z_test(const SampleMean& sample, double expected);

}  // namespace twinray::test

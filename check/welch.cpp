// SPDX-License-Identifier: Apache-2.0
#include "check/welch.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "core/elementary.h"

namespace twinray {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
/// Relative; pictures are floats, whose means are rounded to 2^-24.
constexpr double float_rounding = 1e-6;

/// A variance's share in the denominator of Satterthwaite's degrees of freedom.
double share(const MeanEstimate& one) {
  return one.variance > 0 ? one.variance * one.variance / one.freedom : 0;
}

double freedom_of(double variance, double shares) {
  return shares > 0 ? variance * variance / shares : unbounded;
}

}  // namespace

void MeanOfMeans::add(const MeanEstimate& one) {
  ++count_;
  means_ += one.mean;
  variances_ += one.variance;
  squares_ += share(one);
}

MeanEstimate MeanOfMeans::estimate() const {
  if (count_ == 0) return {};
  const auto n = double(count_);
  return {means_ / n, variances_ / (n * n), freedom_of(variances_, squares_)};
}

WelchTest welch_test(const MeanEstimate& a, const MeanEstimate& b) {
  const double difference = a.mean - b.mean, variance = a.variance + b.variance;
  const double freedom = freedom_of(variance, share(a) + share(b));
  if (std::abs(difference) <= float_rounding * std::max(std::abs(a.mean), std::abs(b.mean)))
    return {0, freedom, 1};
  if (!(variance > 0)) return {difference > 0 ? unbounded : -unbounded, freedom, 0};
  const double t = difference / std::sqrt(variance);
  return {t, freedom, two_sided_p_value(t, freedom)};
}

double two_sided_p_value(double t, double freedom) {
  const boost::math::students_t distribution(freedom);
  return std::min(1.0, 2 * cdf(complement(distribution, std::abs(t))));
}

double corrected_p_value(double least, std::size_t tests) {
  const double sum = least * double(tests);
  // 1 - (1 - p)^n has no digits left where p is tiny; n p is then the same.
  return sum < 1e-6 ? sum : 1 - pow_of(1 - least, double(tests));
}

}  // namespace twinray

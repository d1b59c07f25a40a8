// SPDX-License-Identifier: Apache-2.0
#include "tests/support/statistics.h"

#include <cmath>

namespace twinray::test {
namespace {

/// A normal variable lies below this with a probability of 99 %.
constexpr double z_power = 2.326348;

}  // namespace

double sidak_level(int tests, double family) { return -std::expm1(std::log1p(-family) / tests); }

double z_limit(double level) {
  double low = 0, high = 40;
  for (int step = 0; step < 100; ++step) {
    const double middle = 0.5 * (low + high);
    (std::erfc(middle / std::sqrt(2.0)) > level ? low : high) = middle;
  }
  return low;
}

double seen_error(double standard_error, double level) { return (z_limit(level) + z_power) * standard_error; }

void SampleMean::add(double x) {
  ++count_;
  const double before = x - mean_;
  mean_ += before / double(count_);
  squares_ += before * (x - mean_);
}

double SampleMean::variance() const { return count_ < 2 ? 0 : squares_ / double(count_ - 1); }

double SampleMean::standard_error() const { return count_ == 0 ? 0 : std::sqrt(variance() / double(count_)); }

double z_test(double estimate, double standard_error, double expected) {
  if (standard_error == 0) return estimate == expected ? 1 : 0;
  return std::erfc(std::fabs(estimate - expected) / standard_error / std::sqrt(2.0));
}

double z_test(const SampleMean& sample, double expected) {
  return z_test(sample.mean(), sample.standard_error(), expected);
}

}  // namespace twinray::test

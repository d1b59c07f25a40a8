// SPDX-License-Identifier: Apache-2.0
#include "tests/support/statistics.h"

#include <cmath>

namespace twinray::test {

double sidak_level(int tests, double family) { return -std::expm1(std::log1p(-family) / tests); }

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

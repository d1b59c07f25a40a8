// SPDX-License-Identifier: Apache-2.0
#include "cli/error/summary.h"

#include <algorithm>
#include <cmath>

namespace twinray::error {
namespace {

/// The chance to find a bias, in one row or more, where there is none.
constexpr double bias_level = 0.01;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / double(values.size());
}

double standard_error(const std::vector<double>& values) {
  if (values.size() < 2) return 0;
  const double middle = mean(values), n = double(values.size());
  double squares = 0;
  for (const double value : values) squares += (value - middle) * (value - middle);
  return std::sqrt(squares / (n - 1) / n);
}

Row row_of(const Point& point, const Measurement& measurement, const SquaredError& own) {
  std::vector<double> mses, relatives;
  for (const SquaredError& one : point.errors) {
    mses.push_back(one.mse);
    relatives.push_back(one.relative);
  }
  Row row{.samples = point.samples,
          .samples_per_pixel = mean(point.samples_per_pixel),
          .seeds = point.errors.size(),
          .cpu_seconds = median(point.cpu_seconds),
          .mse = mean(mses) - own.mse,
          .mse_standard_error = standard_error(mses),
          .relative_mse = mean(relatives) - own.relative,
          .bias = {}};
  if (row.seeds >= 2) row.bias = test_bias(point.moments, measurement.converged, measurement.mask);
  return row;
}

Target target_of(const std::vector<Row>& rows, double target) {
  std::vector<ErrorPoint> by_seconds, by_samples;
  for (const Row& row : rows) {
    by_seconds.push_back({row.cpu_seconds, row.mse});
    by_samples.push_back({row.samples_per_pixel, row.mse});
  }
  const double mse = target * target;
  return {target, cost_to_error(by_seconds, mse), cost_to_error(by_samples, mse)};
}

}  // namespace

std::size_t Summary::tests() const {
  std::size_t count = 0;
  for (const CurveSummary& curve : curves)
    for (const Row& row : curve.rows) count += row.bias.has_value();
  return count;
}

Summary summary_of(const Measurement& measurement, const std::vector<double>& target_rmses) {
  Summary summary{
      .own_error = own_error(measurement.converged, measurement.mask),
      .is_noise_known = measurement.converged.noise.has_value(),
      .pixels = measurement.mask.size(),
      .counted_pixels = std::size_t(std::count(measurement.mask.begin(), measurement.mask.end(), 1)),
      .curves = {}};
  for (const Curve& curve : measurement.curves) {
    CurveSummary& one = summary.curves.emplace_back(CurveSummary{curve.name, curve.options, {}, {}});
    for (const Point& point : curve.points)
      if (!point.errors.empty()) one.rows.push_back(row_of(point, measurement, summary.own_error));
    for (const double target : target_rmses) one.targets.push_back(target_of(one.rows, target));
  }
  return summary;
}

double rmse(const Row& row) { return std::sqrt(std::max(0.0, row.mse)); }

bool is_biased(const Row& row, const Summary& summary) {
  return row.bias && corrected_p_value(row.bias->p_value, summary.tests()) < bias_level;
}

}  // namespace twinray::error

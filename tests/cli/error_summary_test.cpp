// SPDX-License-Identifier: Apache-2.0
// What is said of measurements whose numbers are known.
#include "cli/error/summary.h"

#include <cmath>

#include "cli/error/tables.h"
#include "tests/support/catch.h"

namespace twinray::test {
namespace {

using namespace twinray::error;

constexpr int width = 4, height = 2;

Image grey_picture(float value) { return Image(width, height, {value, value, value}); }

/// Against a reference of 1 everywhere, whose noise is 1/8.
Measurement measurement_of(const std::vector<Curve>& curves) {
  return {{grey_picture(1), grey_picture(0.125f)}, PixelMask(width * height, 1), curves};
}

/// A point with a picture of each of these grey values, which took 1, 2, ... seconds.
Point point_of(std::uint32_t samples, const std::vector<float>& values) {
  Point point{.samples = samples, .samples_per_pixel = {}, .cpu_seconds = {}, .errors = {}, .moments = {}};
  for (const float value : values) {
    point.samples_per_pixel.push_back(samples);
    point.cpu_seconds.push_back(double(point.cpu_seconds.size() + 1));
    point.errors.push_back(
        squared_error(grey_picture(value), {grey_picture(1), {}}, PixelMask(std::size_t(width) * height, 1)));
    point.moments.add(grey_picture(value));
  }
  return point;
}

BiasTest test_with(double p_value) {
  BiasTest test;
  test.p_value = p_value;
  return test;
}

/// One set with rows of these p-values.
Summary summary_with(const std::vector<double>& p_values) {
  Summary summary;
  CurveSummary& curve = summary.curves.emplace_back(CurveSummary{"a", {}, {}, {}});
  for (const double p : p_values) curve.rows.push_back({.samples = 4, .bias = test_with(p)});
  return summary;
}

}  // namespace

TEST_CASE("a row is the mean over the seeds without the reference's own error, and the median of the time") {
  const Summary summary = summary_of(measurement_of({{"a", {}, {point_of(4, {1.5f, 2, 1.25f, 0})}}}), {0.5});
  REQUIRE(summary.curves.front().rows.size() == 1);
  const Row& row = summary.curves.front().rows.front();
  // (x - 1)^2 is 1/4, 1, 1/16, 1; the reference's own error is 1/64.
  const double mean = (0.25 + 1 + 0.0625 + 1) / 4;
  CHECK(summary.own_error.mse == 1.0 / 64);
  CHECK(row.mse == Approx(mean - 1.0 / 64));
  CHECK(row.relative_mse == Approx((mean - 1.0 / 64) / 1.01));
  double squares = 0;
  for (const double error : {0.25, 1.0, 0.0625, 1.0}) squares += (error - mean) * (error - mean);
  CHECK(row.mse_standard_error == Approx(std::sqrt(squares / 3 / 4)));
  CHECK(row.cpu_seconds == 2.5);
  CHECK(row.seeds == 4);
  CHECK(rmse(row) == Approx(std::sqrt(row.mse)));
  CHECK(summary.tests() == 1);
}

TEST_CASE("a set's cost to an error is that of its mean squared error") {
  // Errors of 1 and 1/4 at 4 and 16 samples: power -1.
  Measurement measurement = measurement_of({{"a", {}, {point_of(4, {2}), point_of(16, {1.5f})}}});
  measurement.converged.noise.reset();
  const Summary summary = summary_of(measurement, {std::sqrt(0.5), 0.25});
  const std::vector<Target>& targets = summary.curves.front().targets;
  CHECK(targets[0].samples->cost == Approx(8));
  CHECK(!targets[0].samples->is_extrapolated);
  CHECK(targets[1].samples->cost == Approx(64));
  CHECK(targets[1].cpu_seconds->is_extrapolated);
}

TEST_CASE("a row without a picture is left out, and one with a single picture has no spread nor test") {
  const Summary summary =
      summary_of(measurement_of({{"a", {}, {point_of(4, {2}), point_of(16, {})}}}), {0.5});
  REQUIRE(summary.curves.front().rows.size() == 1);
  CHECK(summary.curves.front().rows.front().mse_standard_error == 0);
  CHECK(!summary.curves.front().rows.front().bias.has_value());
  CHECK(summary.tests() == 0);
  CHECK(verdicts(summary).empty());
}

TEST_CASE("a p-value that one test in a hundred has is bias in a single row, and none among many") {
  const Summary alone = summary_with({0.009});
  CHECK(is_biased(alone.curves.front().rows.front(), alone));
  const Summary among = summary_with({0.009, 0.5});
  CHECK(!is_biased(among.curves.front().rows.front(), among));
  const Summary clear = summary_with({0.004, 0.5});
  CHECK(is_biased(clear.curves.front().rows.front(), clear));
  CHECK(!is_biased(clear.curves.front().rows.back(), clear));
  CHECK(verdicts(among) ==
        std::vector<std::string>{"No bias found in 2 tests, at a level of 1 % for all together."});
  CHECK(verdicts(clear) ==
        std::vector<std::string>{"a: biased, or another picture than the reference, at 4 samples."});
}

TEST_CASE("the bias of a picture that is too bright is positive, of one too dark negative") {
  const Summary summary = summary_of(
      measurement_of({{"a", {}, {point_of(4, {1.75f, 2.25f}), point_of(16, {0.25f, 0.75f})}}}), {0.5});
  const std::vector<Row>& rows = summary.curves.front().rows;
  // Seeds: +- 1/4 in each pixel, as a mean of two 1/4; the reference: 1/8. Over the root of 8 pixels.
  const double percent = 100 * std::sqrt((1.0 / 16 + 1.0 / 64) / 8);
  CHECK(bias_cell(rows[0]) == fmt::format("{:+.3f} ± {:.3f} %", 100.0, percent));
  CHECK(bias_cell(rows[1]) == fmt::format("{:+.3f} ± {:.3f} %", -50.0, percent));
}

TEST_CASE("a reference is too noisy from a tenth of the least error on") {
  Summary summary = summary_with({0.5, 0.5});
  summary.is_noise_known = true;
  summary.own_error.mse = 1;
  summary.curves.front().rows[0].mse = 100;
  summary.curves.front().rows[1].mse = 10.5;
  CHECK(reference_warning(summary).empty());
  summary.curves.front().rows[1].mse = 9.5;
  CHECK(
      reference_warning(summary).starts_with("the reference's own mean squared error, 1, is more than 10 %"));
  summary.own_error.mse = 0;
  summary.curves.front().rows[1].mse = 0;
  CHECK(reference_warning(summary).empty());
}

}  // namespace twinray::test

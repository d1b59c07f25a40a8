// SPDX-License-Identifier: Apache-2.0
// What a measurement says: the rows of the table, and what follows from them.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "check/convergence.h"
#include "cli/error/measurement.h"

namespace twinray::error {

/// One set of options with one number of samples, over all seeds. Errors are without the converged picture's
/// own.
struct Row {
  std::uint32_t samples = 0;
  double samples_per_pixel = 0;
  std::size_t seeds = 0;
  double cpu_seconds = 0;         ///< The median.
  double mse = 0;                 ///< The mean.
  double mse_standard_error = 0;  ///< From the spread over the seeds; 0 for a single one.
  double relative_mse = 0;
  std::optional<BiasTest> bias;  ///< From two seeds on.
};

/// What one set of options takes to an error.
struct Target {
  double rmse = 0;
  std::optional<CostToError> cpu_seconds, samples;
};

struct CurveSummary {
  std::string name;
  Words options;
  std::vector<Row> rows;  ///< Those with a complete picture.
  std::vector<Target> targets;
};

struct Summary {
  SquaredError own_error;  ///< Of the converged picture.
  bool is_noise_known = false;
  std::size_t pixels = 0, counted_pixels = 0;
  std::vector<CurveSummary> curves;

  std::size_t tests() const;  ///< For bias: rows that have one.
};

Summary summary_of(const Measurement& measurement, const std::vector<double>& target_rmses);

/// The mean squared error's root; 0 where the error is lost in the noise of the converged picture.
double rmse(const Row& row);

/// Whether bias is found, at the level of 1 % for all tests of the summary together.
bool is_biased(const Row& row, const Summary& summary);

}  // namespace twinray::error

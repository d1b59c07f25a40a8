// SPDX-License-Identifier: Apache-2.0
// How long an estimator takes to a given error.
#pragma once
#include <optional>
#include <span>

namespace twinray {

/// A measured point of an estimator's error over what it cost: seconds, or samples.
struct ErrorPoint {
  double cost = 0, mse = 0;  ///< Mean squared error.
};

struct CostToError {
  double cost = 0;
  bool is_extrapolated = false;  ///< Beyond the measured points, by error ~ 1 / cost.
};

/// The cost from which on the error stays at or below `mse` > 0: between two points by a power law through
/// both, beyond them by that of independent samples. Points without a positive cost and error say nothing;
/// none of them: no answer. The points are in the order of their costs.
std::optional<CostToError> cost_to_error(std::span<const ErrorPoint> points, double mse);

}  // namespace twinray

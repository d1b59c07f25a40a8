// SPDX-License-Identifier: Apache-2.0
#include "check/convergence.h"

#include <vector>

#include "core/elementary.h"

namespace twinray {
namespace {

/// Where the power law through both points has this error; the first one's is greater.
double between(const ErrorPoint& a, const ErrorPoint& b, double mse) {
  const double part = log2_of(a.mse / mse) / log2_of(a.mse / b.mse);
  return a.cost * exp2_of(part * log2_of(b.cost / a.cost));
}

}  // namespace

std::optional<CostToError> cost_to_error(std::span<const ErrorPoint> points, double mse) {
  std::vector<ErrorPoint> valid;
  for (const ErrorPoint& point : points)
    if (point.cost > 0 && point.mse > 0) valid.push_back(point);
  if (valid.empty()) return std::nullopt;
  std::size_t reached = valid.size();  // The first of those at the end that have all reached it.
  while (reached > 0 && valid[reached - 1].mse <= mse) --reached;
  if (reached > 0 && reached < valid.size())
    return CostToError{between(valid[reached - 1], valid[reached], mse), false};
  const ErrorPoint& end = reached == 0 ? valid.front() : valid.back();
  return CostToError{end.cost * end.mse / mse, end.mse != mse};
}

}  // namespace twinray

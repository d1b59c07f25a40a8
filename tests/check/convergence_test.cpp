// SPDX-License-Identifier: Apache-2.0
#include "check/convergence.h"

#include <vector>

#include "tests/support/catch.h"

namespace twinray::test {
namespace {

const std::vector<ErrorPoint> points{{1, 0.1}, {4, 0.02}, {16, 0.005}};

}  // namespace

TEST_CASE("between two points the error follows the power law through both") {
  // From 0.02 to 0.005 over a factor of 4 in cost, the exponent is -1: half the error at twice the cost.
  CHECK(cost_to_error(points, 0.01)->cost == Approx(8));
  // From 0.1 to 0.02 over a factor of 4: the geometric mean of errors is at that of costs.
  CHECK(cost_to_error(points, 0.0447213595)->cost == Approx(2));
  CHECK(cost_to_error(points, 0.02)->cost == Approx(4));
  for (const double mse : {0.01, 0.0447213595, 0.02}) CHECK(!cost_to_error(points, mse)->is_extrapolated);
}

TEST_CASE("beyond the points the error halves as the cost doubles, and that is said") {
  CHECK(cost_to_error(points, 0.0025)->cost == Approx(32));
  CHECK(cost_to_error(points, 0.0025)->is_extrapolated);
  CHECK(cost_to_error(points, 0.2)->cost == Approx(0.5));
  CHECK(cost_to_error(points, 0.2)->is_extrapolated);
  CHECK(cost_to_error(points, 0.1)->cost == 1);
  CHECK(!cost_to_error(points, 0.1)->is_extrapolated);
}

TEST_CASE("an error counts as reached where it is not passed again") {
  const std::vector<ErrorPoint> lucky{{1, 0.005}, {4, 0.02}, {16, 0.005}};
  CHECK(cost_to_error(lucky, 0.01)->cost == Approx(8));
}

TEST_CASE("points whose error is lost in the reference's noise say nothing") {
  const std::vector<ErrorPoint> lost{{1, 0.1}, {4, 0.025}, {16, -1e-5}};
  CHECK(cost_to_error(lost, 0.05)->cost == Approx(2));
  CHECK(cost_to_error(lost, 0.0125)->is_extrapolated);
  CHECK(!cost_to_error(std::vector<ErrorPoint>{{1, 0}}, 0.1));
  CHECK(!cost_to_error({}, 0.1));
}

}  // namespace twinray::test

// SPDX-License-Identifier: Apache-2.0
#include "bench/statistics.h"

#include <cmath>

#include "tests/support/catch.h"

namespace twinray::bench {
namespace {

void check_quartiles(const std::vector<double>& values, double low, double median, double high) {
  const Quartiles found = quartiles(values);
  CHECK(found.low == low);
  CHECK(found.median == median);
  CHECK(found.high == high);
}

}  // namespace

TEST_CASE("quartiles are interpolated between the sorted values") {
  check_quartiles({4, 1, 3, 2}, 1.75, 2.5, 3.25);
  check_quartiles({50, 10, 40, 20, 30}, 20, 30, 40);
  check_quartiles({20, 10}, 12.5, 15, 17.5);
  check_quartiles({3, 100, 1, 2, 4, 5}, 2.25, 3.5, 4.75);
}

TEST_CASE("one value is all of its quartiles, and no value gives zeros") {
  check_quartiles({7}, 7, 7, 7);
  check_quartiles({}, 0, 0, 0);
}

TEST_CASE("an engine's mean is the geometric one of the ray sets that the scene has, round by round") {
  constexpr double rounding = 1e-12;
  EngineStatistics engine;
  engine.trace[0].speed = {1, 2, 9};
  engine.trace[2].speed = {4, 8, 1};
  engine.trace[0].nanoseconds = {10, 100, 30};
  engine.trace[4].nanoseconds = {1000, 100, 30};
  const double speed[3] = {2, 4, 3}, nanoseconds[3] = {100, 100, 30};
  REQUIRE(engine.mean_speed().size() == 3);
  REQUIRE(engine.mean_nanoseconds().size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(std::fabs(engine.mean_speed()[i] / speed[i] - 1) < rounding);
    CHECK(std::fabs(engine.mean_nanoseconds()[i] / nanoseconds[i] - 1) < rounding);
  }
}

TEST_CASE("an engine that was not timed has no means") { CHECK(EngineStatistics{}.mean_speed().empty()); }

}  // namespace twinray::bench

// SPDX-License-Identifier: Apache-2.0
#include "core/phase_function.h"

#include <cmath>

#include "core/warp.h"
#include "tests/support/catch.h"
#include "tests/support/chi_square.h"
#include "tests/support/random.h"

namespace twinray::test {
namespace {

constexpr float anisotropies[] = {-0.99f, -0.5f, -1e-3f, 0, 5e-4f, 1e-3f, 0.3f, 0.85f, 0.99f};

/// Of cosines from `low` to `high`, a part of the sphere around the axis, by the closed form of the integral.
double probability_between(double g, double low, double high) {
  if (g == 0) return (high - low) / 2;
  const auto below = [&](double cosine) {
    return (1 - g * g) / (2 * g) * (1 / std::sqrt(1 + g * g - 2 * g * cosine) - 1 / (1 + g));
  };
  return below(high) - below(low);
}

}  // namespace

TEST_CASE("a phase function is a density over all directions, of the mean cosine that it is made for") {
  constexpr int steps = 200000;
  for (const float g : anisotropies) {
    CAPTURE(g);
    const PhaseFunction phase(g);
    double sum = 0, cosines = 0;
    for (int i = 0; i < steps; ++i) {
      // Cosines near +-1 count most: steps of x with cos = x^3 are small there, from either end.
      const double x = (i + 0.5) / steps, end = g < 0 ? -1 : 1;
      const double cosine = end * (1 - 2 * x * x * x);
      const double part = 2 * double(pi) * double(phase.evaluate(float(cosine))) * 6 * x * x / steps;
      sum += part;
      cosines += part * cosine;
    }
    CHECK(sum == Approx(1).epsilon(2e-3));
    CHECK(cosines == Approx(g).margin(2e-3));
  }
}

TEST_CASE("a phase function is even without anisotropy, and scatters forward with it") {
  for (const float cosine : {-1.0f, -0.3f, 0.0f, 0.7f, 1.0f})
    CHECK(PhaseFunction(0).evaluate(cosine) == Approx(1 / (4 * double(pi))));
  CHECK(PhaseFunction(0.5f).evaluate(1) == Approx(1.5 * 4 / (4 * double(pi) * 1)).epsilon(1e-5));
  CHECK(PhaseFunction(0.5f).evaluate(1) > PhaseFunction(0.5f).evaluate(-1));
  CHECK(PhaseFunction(-0.5f).evaluate(-1) == PhaseFunction(0.5f).evaluate(1));
}

TEST_CASE("a phase function chooses directions by its density") {
  constexpr int count = 200000, columns = 16, rows = 12;
  Random random(3);
  for (const float g : anisotropies) {
    CAPTURE(g);
    const PhaseFunction phase(g);
    Grid grid(columns, rows);
    for (int i = 0; i < count; ++i) {
      const Vec3 wi = phase.sample(in_square(random));
      REQUIRE(std::fabs(length(wi) - 1) < 1e-6f);
      const double turn = std::atan2(double(wi.y), double(wi.x)) / (2 * double(pi));
      // Equal parts of its distribution, for which each is as likely.
      grid.add(turn < 0 ? turn + 1 : turn, std::min(1.0, probability_between(double(g), -1, double(-wi.z))));
    }
    check_uniform(grid.counts(), 2 * int(std::size(anisotropies)), 0.03);
  }
}

TEST_CASE("draws at the ends of the square give directions as well") {
  constexpr float ends[] = {0, 0x1p-24f, 0x1.fffffep-1f};
  for (const float g : anisotropies)
    for (const float x : ends)
      for (const float y : ends) {
        const PhaseFunction phase(g);
        const Vec3 wi = phase.sample({x, y});
        CHECK(std::fabs(length(wi) - 1) < 1e-6f);
        CHECK(phase.evaluate(-wi.z) > 0);
        CHECK(std::isfinite(phase.evaluate(-wi.z)));
      }
}

}  // namespace twinray::test

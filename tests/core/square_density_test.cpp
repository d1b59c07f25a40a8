// SPDX-License-Identifier: Apache-2.0
#include "core/square_density.h"

#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/chi_square.h"
#include "tests/support/error_text.h"
#include "tests/support/random.h"

namespace twinray {
namespace {

using test::error_text;

/// Two slices of 4 x 3 nodes: one that is 0 in places, and one that is not.
SquareDensity two_densities() {
  return SquareDensity(SquareTable<float>(4, 3, {0, 0, 2, 1, 0, 1, 5, 0, 3, 0, 0, 1,  //
                                                 1, 2, 3, 4, 9, 1, 1, 1, 2, 2, 2, 2}));
}

SliceBlend blend_of(double first) {
  SliceBlend blend;
  blend.slices = {0, 1};
  blend.weights = {first, 1 - first};
  blend.count = 2;
  return blend;
}

/// Over cells of 1 / 256.
double integral_of(const SquareDensity& density, const SliceBlend& blend) {
  constexpr int steps = 256;
  double sum = 0;
  for (int y = 0; y < steps; ++y)
    for (int x = 0; x < steps; ++x)
      sum += double(density.pdf({(float(x) + 0.5f) / steps, (float(y) + 0.5f) / steps}, blend));
  return sum / (steps * steps);
}

}  // namespace

TEST_CASE("a table is its numbers at the nodes and bilinear between them, in a blend of its slices") {
  const SquareTable<float> table(3, 2, {1, 3, 5, 2, 4, 8, 10, 10, 10, 10, 10, 10});
  CHECK(table.slices() == 2);
  CHECK(table.at({0, 0}) == 1);
  CHECK(table.at({1, 1}) == 8);
  CHECK(table.at({0.5f, 0}) == 3);
  CHECK(table.at({0.25f, 0}) == 2);
  CHECK(table.at({0.75f, 0.5f}) == Approx(5));
  CHECK(table.at({0.75f, 0.5f}, blend_of(0.25)) == Approx(0.25 * 5 + 0.75 * 10));
}

TEST_CASE("a blend of densities integrates to one, and is what slices have in proportion") {
  const SquareDensity density = two_densities();
  for (const double first : {1.0, 0.5, 0.125, 0.0}) {
    CAPTURE(first);
    CHECK(integral_of(density, blend_of(first)) == Approx(1).epsilon(1e-4));
    const Vec2 point{0.3f, 0.8f};
    CHECK(density.pdf(point, blend_of(first)) ==
          Approx(first * double(density.pdf(point, blend_of(1))) +
                 (1 - first) * double(density.pdf(point, blend_of(0)))));
  }
  // The first slice: what its six cells hold is 1/4 of the sum of each one's corners.
  const double sum =
      (0 + 0 + 0 + 1 + 0 + 2 + 1 + 5 + 2 + 1 + 5 + 0 + 0 + 1 + 3 + 0 + 1 + 5 + 0 + 0 + 5 + 0 + 0 + 1) / 4.0;
  CHECK(density.pdf({2.0f / 3, 0.5f}, blend_of(1)) == Approx(5 / sum * 6));
}

TEST_CASE("points are sampled with the density that is stated, and taken back to where they came from") {
  const SquareDensity density = two_densities();
  for (const double first : {1.0, 0.4, 0.0}) {
    const SliceBlend blend = blend_of(first);
    test::Random random(5);
    test::Grid grid(12, 12);
    constexpr int samples = 100000;
    for (int i = 0; i < samples; ++i) {
      const float x = random.unit();
      const float y = random.unit();
      const auto [point, pdf] = density.sample({x, y}, blend);
      REQUIRE((point.x >= 0 && point.x <= 1 && point.y >= 0 && point.y <= 1));
      REQUIRE(pdf == Approx(density.pdf(point, blend)).epsilon(1e-3).margin(1e-3));
      grid.add(double(point.x), double(point.y));
      const auto [back, same] = density.invert(point, blend);
      REQUIRE(same == density.pdf(point, blend));
      // A place is known to 2^-24; where the density is low, many numbers lead to one.
      const double slack = 1e-5 + 3e-7 / std::max(double(pdf), 1e-3);
      REQUIRE(std::fabs(double(back.x) - double(x)) < 30 * slack);
      REQUIRE(std::fabs(double(back.y) - double(y)) < 30 * slack);
    }
    std::vector<double> expected(144);
    for (int y = 0; y < 240; ++y)
      for (int x = 0; x < 240; ++x)
        expected[std::size_t(y / 20 * 12 + x / 20)] +=
            samples / 57600.0 *
            double(density.pdf({(float(x) + 0.5f) / 240, (float(y) + 0.5f) / 240}, blend));
    test::check_counts(grid.counts(), expected, 3, 0.05);
  }
}

TEST_CASE("the corners of the square stay in it, and nothing is sampled where the density is 0") {
  const SquareDensity density(SquareTable<float>(3, 3, {0, 0, 0, 0, 0, 0, 0, 0, 1}));
  for (const float x : {0.0f, 0.5f, 0x1.fffffep-1f})
    for (const float y : {0.0f, 0.5f, 0x1.fffffep-1f}) {
      const auto [point, pdf] = density.sample({x, y}, {});
      CHECK((point.x >= 0.5f && point.x <= 1 && point.y >= 0.5f && point.y <= 1));
      CHECK(std::isfinite(pdf));
    }
  // The density is (4 x' y') with x' = 2 x - 1: half of it lies above the root of a half.
  CHECK(density.sample({0.5f, 0.5f}, {}).point.x == Approx(0.5 + 0.5 * std::sqrt(0.5)));
  CHECK(density.sample({0.5f, 0.25f}, {}).point.y == Approx(0.75));
  CHECK(density.invert({0.25f, 0.25f}, {}).pdf == 0);
}

TEST_CASE("a slice of zeros has the same density everywhere") {
  const SquareDensity density(SquareTable<float>(3, 2, {0, 0, 0, 0, 0, 0}));
  CHECK(density.pdf({0.1f, 0.9f}, {}) == 1);
  CHECK(density.sample({0.25f, 0.75f}, {}).point == Vec2{0.25f, 0.75f});
  const SquareDensity tiny(SquareTable<float>(2, 2, {0, 1e-40f, 0, 0}));
  CHECK(tiny.sample({0.25f, 0.75f}, {}).point == Vec2{0.25f, 0.75f});
}

TEST_CASE("tables and densities that cannot be are refused") {
  const auto table_error = [](std::size_t width, std::size_t height, std::vector<float> values) {
    return error_text([&] { SquareDensity(SquareTable<float>(width, height, std::move(values))); });
  };
  CHECK(table_error(2, 2, {1, 2, 3, 4}) == "");
  CHECK(table_error(1, 4, {1, 2, 3, 4}) == "a table needs two rows and two columns at least");
  CHECK(table_error(4, 1, {1, 2, 3, 4}) == "a table needs two rows and two columns at least");
  CHECK(table_error(2, 2, {1, 2, 3}) == "a table needs a number for each of its nodes");
  CHECK(table_error(2, 2, {}) == "a table needs a number for each of its nodes");
  CHECK(table_error(2, 2, {1, 2, -1, 3}) == "a density has a number that is negative or not finite");
  CHECK(table_error(2, 2, {1, 2, NAN, 3}) == "a density has a number that is negative or not finite");
  CHECK(table_error(2, 2, {3e38f, 3e38f, 3e38f, 3e38f}) == "");
  CHECK(table_error(3, 3, std::vector<float>(9, 3e38f)) == "the numbers of a density are too large");
}

}  // namespace twinray

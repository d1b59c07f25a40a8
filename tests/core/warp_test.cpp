// SPDX-License-Identifier: Apache-2.0
#include "core/warp.h"

#include <cmath>
#include <functional>

#include "tests/support/catch.h"
#include "tests/support/chi_square.h"
#include "tests/support/random.h"

namespace twinray {
namespace {

using test::Grid;
using test::in_square;
using test::Random;

constexpr int samples = 200000, grid_columns = 24, grid_rows = 16;
constexpr double two_pi = 6.283185307179586;
/// Points are rounded to float, so they may be this far from where they belong.
constexpr double of_rounding = 4e-7;
/// u on and just inside the edges of the square.
constexpr float edges[] = {0.0f, 0x1p-24f, 0.25f, 0.5f, 0.75f, 0x1.fffffep-1f};

/// The azimuth as a part of a turn, in [0, 1].
double turn(double x, double y) { return std::atan2(-y, -x) / two_pi + 0.5; }

double unit_error(const Vec3& w) {
  return std::fabs(std::sqrt(double(w.x) * w.x + double(w.y) * w.y + double(w.z) * w.z) - 1);
}

/// 1 - z of a unit direction, not taken from z, which has lost its digits near 1; z >= 0.
double one_minus_z(const Vec3& w) {
  const double r2 = double(w.x) * w.x + double(w.y) * w.y;
  return r2 / (1 + std::sqrt(std::max(0.0, 1 - r2)));
}

struct Counts {
  std::vector<std::size_t> observed;
  std::vector<double> expected;
};

/// Samples a warp of directions with z >= low, and what a density that depends on z alone expects.
Counts count_directions(const std::function<Vec3(Vec2)>& warp, const std::function<double(double)>& pdf,
                        double low) {
  Random random(17);
  Grid grid(grid_columns, grid_rows);
  for (int i = 0; i < samples; ++i) {
    const Vec3 w = warp(in_square(random));
    REQUIRE(unit_error(w) <= of_rounding);
    REQUIRE(w.z >= low - of_rounding);
    grid.add(turn(w.x, w.y), (w.z - low) / (1 - low));
  }
  std::vector<double> expected;
  for (int row = 0; row < grid_rows; ++row) {
    const double height = (1 - low) / grid_rows,
                 z = low + (row + 0.5) * height;  // The densities are linear in z.
    expected.insert(expected.end(), grid_columns, samples * pdf(z) * height * two_pi / grid_columns);
  }
  return {{grid.counts().begin(), grid.counts().end()}, expected};
}

}  // namespace

TEST_CASE("points of the disc are uniform by area") {
  Random random(3);
  Grid grid(grid_columns, grid_rows);
  for (int i = 0; i < samples; ++i) {
    const Vec2 p = square_to_disc(in_square(random));
    const double r2 = double(p.x) * p.x + double(p.y) * p.y;
    REQUIRE(r2 <= 1 + of_rounding);
    grid.add(turn(p.x, p.y), r2);
  }
  test::check_uniform(grid.counts(), 1, 0.03);
}

TEST_CASE("directions follow their densities") {
  const auto check = [](const Counts& counts) {
    test::check_counts(counts.observed, counts.expected, 3, 0.03);
  };
  check(count_directions(
      square_to_cosine_hemisphere, [](double z) { return cosine_hemisphere_pdf(float(z)); }, 0));
  check(count_directions(
      square_to_uniform_hemisphere, [](double) { return uniform_hemisphere_pdf(); }, 0));
  check(count_directions(
      square_to_uniform_sphere, [](double) { return uniform_sphere_pdf(); }, -1));
}

TEST_CASE("the test of directions sees a wrong density") {
  const Counts counts = count_directions(
      square_to_uniform_hemisphere, [](double z) { return cosine_hemisphere_pdf(float(z)); }, 0);
  CHECK(test::chi_square(counts.observed, counts.expected).p_value < 1e-9);
}

TEST_CASE("directions of a cone are uniform, in narrow cones too") {
  const float cones[] = {2.0f, 1.0f, 0.1f, 1e-3f, 1e-6f, 1e-12f};
  for (const float one_minus_cos : cones) {
    CAPTURE(one_minus_cos);
    Random random(5);
    Grid grid(grid_columns, grid_rows);
    for (int i = 0; i < samples; ++i) {
      const Vec3 w = square_to_uniform_cone(in_square(random), one_minus_cos);
      REQUIRE(unit_error(w) <= of_rounding);
      const double depth = w.z < 0 ? 1.0 - w.z : one_minus_z(w);
      REQUIRE(depth <= one_minus_cos * (1 + 4 * of_rounding));
      grid.add(turn(w.x, w.y), depth / one_minus_cos);
    }
    test::check_uniform(grid.counts(), int(std::size(cones)), 0.03);
    CHECK(uniform_cone_pdf(one_minus_cos) == Approx(1 / (two_pi * one_minus_cos)));
  }
}

TEST_CASE("points of the triangle are uniform by area") {
  Random random(7);
  Grid grid(grid_columns, grid_rows);
  for (int i = 0; i < samples; ++i) {
    const Vec2 weights = square_to_triangle(in_square(random));
    REQUIRE(weights.x >= 0);
    REQUIRE(weights.y >= 0);
    const double sum = double(weights.x) + weights.y;
    REQUIRE(sum <= 1);
    grid.add(sum > 0 ? weights.y / sum : 0, sum * sum);  // Uniform, if the triangle's points are.
  }
  test::check_uniform(grid.counts(), 1, 0.03);
}

TEST_CASE("densities integrate to one") {
  CHECK(uniform_hemisphere_pdf() * two_pi == Approx(1));
  CHECK(uniform_sphere_pdf() * 2 * two_pi == Approx(1));
  CHECK(cosine_hemisphere_pdf(0.5f) * two_pi == Approx(1));  // The mean over z, since it is linear.
  CHECK(cosine_hemisphere_pdf(-0.5f) == 0);
}

TEST_CASE("warps stay in their domain on the edges of the square") {
  for (const float x : edges)
    for (const float y : edges) {
      CAPTURE(x, y);
      const Vec2 u = {x, y};
      CHECK(length_squared({square_to_disc(u).x, square_to_disc(u).y, 0}) <= 1 + of_rounding);
      CHECK(unit_error(square_to_cosine_hemisphere(u)) <= of_rounding);
      CHECK(square_to_cosine_hemisphere(u).z >= 0);
      CHECK(unit_error(square_to_uniform_hemisphere(u)) <= of_rounding);
      CHECK(square_to_uniform_hemisphere(u).z > 0);
      CHECK(unit_error(square_to_uniform_sphere(u)) <= of_rounding);
      CHECK(unit_error(square_to_uniform_cone(u, 1e-20f)) <= of_rounding);
      const Vec2 weights = square_to_triangle(u);
      CHECK(weights.x >= 0);
      CHECK(weights.y >= 0);
      CHECK(double(weights.x) + weights.y <= 1);
    }
}

TEST_CASE("the disc's centre and corners come from the square's") {
  CHECK(square_to_disc({0.5f, 0.5f}) == Vec2{0, 0});
  const float diagonal = std::sqrt(0.5f);
  CHECK(square_to_disc({0, 0}).x == Approx(-diagonal));
  CHECK(square_to_disc({0, 0}).y == Approx(-diagonal));
  CHECK(square_to_disc({0.5f, 0}).x == Approx(0).margin(of_rounding));
  CHECK(square_to_disc({0.5f, 0}).y == Approx(-1));
}

TEST_CASE("points of a polygon are uniform by area within its corners") {
  for (const auto& [corners, turns] : {std::pair(3, 0.0f), {5, 0.3f}, {6, 0.0f}}) {
    Random random(5);
    const double middle_angle = M_PI / corners, height = std::cos(middle_angle);
    Grid grid(corners * 4, 4);
    for (int i = 0; i < samples; ++i) {
      const Vec2 p = square_to_polygon(in_square(random), corners, turns);
      // In a triangle from the middle to one side: how far out, and how far along.
      double place = std::atan2(p.y, p.x) / two_pi - double(turns);
      place = (place - std::floor(place)) * corners;
      const double blade = std::floor(place), angle = (2 * (place - blade) - 1) * middle_angle;
      const double outward = std::hypot(p.x, p.y) * std::cos(angle) / height;
      REQUIRE(outward <= 1 + 1e-6);
      const double along = (std::tan(angle) / std::tan(middle_angle) + 1) / 2;
      grid.add(std::min((blade + along) / corners, 0.999999), std::min(outward * outward, 0.999999));
    }
    test::check_uniform(grid.counts(), 3, 0.03);
  }
}

TEST_CASE("the corners of a polygon lie on the unit circle, the first one as far around as is said") {
  const Vec2 corner = square_to_polygon({0, 1}, 5, 0.25f), middle = square_to_polygon({0.4f, 0}, 5, 0.25f);
  CHECK(corner.x == Approx(0).margin(of_rounding));
  CHECK(corner.y == Approx(1));
  CHECK(middle == Vec2{0, 0});
  const Vec2 side = square_to_polygon({0.125f, 1}, 4, 0);
  CHECK(side.x == Approx(0.5));
  CHECK(side.y == Approx(0.5));
}

}  // namespace twinray

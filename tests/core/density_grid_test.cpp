// SPDX-License-Identifier: Apache-2.0
#include "core/density_grid.h"

#include <cmath>
#include <limits>

#include "tests/support/catch.h"
#include "tests/support/error_text.h"
#include "tests/support/random.h"

namespace twinray::test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Random numbers, a third of them 0.
std::vector<float> some_values(const DensityGrid::Size& size) {
  Random random(11);
  std::vector<float> values(std::size_t(size[0] * size[1] * size[2]));
  for (float& value : values) value = random.below(3) == 0 ? 0 : random.uniform(0, 2);
  return values;
}

/// By the definition, in double.
double density_at(const DensityGrid::Size& size, const std::vector<float>& values, const double (&unit)[3]) {
  int first[3];
  double part[3];
  for (int k = 0; k < 3; ++k) {
    if (unit[k] < 0 || unit[k] > 1) return 0;
    const double place = unit[k] * size[std::size_t(k)] - 0.5;
    first[k] = int(std::floor(place));
    part[k] = place - first[k];
  }
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    int at[3];
    double weight = 1;
    bool is_inside = true;
    for (int k = 0; k < 3; ++k) {
      const int far = corner >> k & 1;
      at[k] = first[k] + far;
      weight *= far ? part[k] : 1 - part[k];
      is_inside = is_inside && at[k] >= 0 && at[k] < size[std::size_t(k)];
    }
    if (is_inside) sum += weight * double(values[std::size_t((at[2] * size[1] + at[1]) * size[0] + at[0])]);
  }
  return sum;
}

/// By many small steps.
double amount_of(const DensityGrid::Size& size, const std::vector<float>& values, const Transform& to_unit,
                 const Ray& ray, double from, double to) {
  constexpr int steps = 40000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double t = from + (to - from) * (i + 0.5) / steps;
    const double p[3] = {double(ray.origin.x) + double(ray.direction.x) * t,
                         double(ray.origin.y) + double(ray.direction.y) * t,
                         double(ray.origin.z) + double(ray.direction.z) * t};
    double unit[3];
    for (int k = 0; k < 3; ++k)
      unit[k] = to_unit.m[k][0] * p[0] + to_unit.m[k][1] * p[1] + to_unit.m[k][2] * p[2] + to_unit.m[k][3];
    sum += density_at(size, values, unit) * (to - from) / steps;
  }
  return sum * double(length(ray.direction));
}

std::string error_of(const DensityGrid::Size& size, const std::vector<float>& values,
                     const Transform& to_unit = {}) {
  return error_text([&] { DensityGrid(size, values, to_unit); });
}

}  // namespace

TEST_CASE("what a grid has along a ray is the integral of its trilinear density") {
  const DensityGrid::Size size{5, 3, 4};
  const std::vector<float> values = some_values(size);
  const Transform placed =
      Transform::translation(1, -2, 0.5) * Transform::rotation({1, 2, 3}, 40) * Transform::scaling(2, 1, 3);
  const Transform to_unit = placed.inverse();
  const DensityGrid grid(size, values, to_unit);
  Random random(5);
  int crossed = 0;
  for (int i = 0; i < 40; ++i) {
    const Vec3 target = placed.point({random.unit(), random.unit(), random.unit()});
    const Vec3 origin = target + random.in_ball() * (i % 2 == 0 ? 6.0f : 0.5f);
    const Ray ray{.origin = origin, .direction = (target - origin) * 0.5f};
    const double expected = amount_of(size, values, to_unit, ray, 0.5, 3);
    CHECK(grid.amount(ray, 0.5f, 3) == Approx(expected).epsilon(2e-3).margin(1e-4));
    crossed += expected > 0.1;
    // Parts of it add up.
    CHECK(grid.amount(ray, 0.5f, 1.25f) + grid.amount(ray, 1.25f, 3) ==
          Approx(grid.amount(ray, 0.5f, 3)).epsilon(1e-9).margin(1e-12));
  }
  CHECK(crossed > 20);
}

TEST_CASE("a grid is reached where so much lies before, and no further than where there is so much") {
  const DensityGrid::Size size{6, 6, 6};
  const DensityGrid grid(size, some_values(size), {});
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const Vec3 origin = Vec3{0.5f, 0.5f, 0.5f} + random.in_ball() * 2.0f;
    const Ray ray{.origin = origin, .direction = Vec3{random.unit(), random.unit(), random.unit()} - origin};
    const double whole = grid.amount(ray, 0, infinity);
    CHECK(grid.reach(ray, 0, infinity, whole * 1.001 + 1e-6).t == infinity);
    if (whole < 1e-3) continue;
    for (const double part : {1e-3, 0.3, 0.9}) {
      const float t = grid.reach(ray, 0, infinity, whole * part).t;
      REQUIRE(t < infinity);
      CHECK(grid.amount(ray, 0, t) == Approx(whole * part).epsilon(1e-4).margin(1e-6));
      CHECK(grid.reach(ray, 0, t * 0.99f, whole * part).t == infinity);
      CHECK(grid.reach(ray, 0, t * 0.5f, whole * part).amount == grid.amount(ray, 0, t * 0.5f));
      CHECK(grid.reach(ray, 0, infinity, whole * part).amount == whole * part);
      // From behind its beginning.
      CHECK(grid.amount(ray, t, grid.reach(ray, t, infinity, whole * (1 - part) * 0.5).t) ==
            Approx(whole * (1 - part) * 0.5).epsilon(1e-3));
    }
  }
}

TEST_CASE("rays along the axes, in the planes of a grid, and beside it end well") {
  const DensityGrid grid({2, 2, 2}, std::vector<float>(8, 3.0f), {});
  const auto through = [&](const Vec3& origin, const Vec3& direction) {
    return grid.amount({.origin = origin, .direction = direction}, 0, infinity);
  };
  // Half a cell at either end falls from 3 to 1.5, in each of the other axes nothing where it is the middle.
  CHECK(through({0.5f, 0.5f, -1}, {0, 0, 1}) == Approx(3 * 0.5 + 2 * 2.25 * 0.25));
  CHECK(through({0.5f, 0.5f, 9}, {0, 0, -5}) == Approx(3 * 0.5 + 2 * 2.25 * 0.25));
  CHECK(through({0.25f, 0.75f, -1}, {0, 0, 1}) == Approx(3 * 0.5 + 2 * 2.25 * 0.25));
  CHECK(through({0.5f, 0.5f, 0.5f}, {0, 0, 1}) == Approx(0.5 * (3 * 0.5 + 2 * 2.25 * 0.25)));
  CHECK(through({0, 0.5f, -1}, {0, 0, 1}) == Approx(0.5 * (3 * 0.5 + 2 * 2.25 * 0.25)));
  CHECK(through({2, 0.5f, -1}, {0, 0, 1}) == 0);
  CHECK(through({0.5f, 0.5f, 2}, {0, 0, 1}) == 0);
  CHECK(grid.at({0.5f, infinity, 0.5f}) == 0);
  CHECK(grid.at({0.5f, 0.5f, std::nanf("")}) == 0);
  CHECK(through({0.5f, 0.5f, 1e3f}, {0, 0, -1e15f}) == Approx(3 * 0.5 + 2 * 2.25 * 0.25).epsilon(1e-3));
}

TEST_CASE("a grid of densities that cannot be is refused") {
  CHECK(error_of({1, 1, 2}, {0, 1}) == "");
  CHECK(error_of({0, 1, 1}, {}) == "a grid of 0 x 1 x 1 densities; each must be from 1 to 16384");
  CHECK(error_of({20000, 1, 1}, {1}).find("each must be from 1 to 16384") != std::string::npos);
  CHECK(error_of({2, 1, 1}, {1}) == "a grid of 2 x 1 x 1 densities has 1 numbers; it must have 2");
  CHECK(error_of({1, 1, 1}, {-1}) == "a number of the grid is -1; it must be finite and >= 0");
  CHECK(error_of({1, 1, 1}, {infinity}).find("finite") != std::string::npos);
  CHECK(error_of({1, 1, 1}, {1}, Transform::scaling(1, 0, 1)) ==
        "a grid of densities lies in a box that is flat or too large");
  CHECK(error_of({3000, 3000, 3000}, {}).find("in all they must not be more than 8589934592") !=
        std::string::npos);
  const DensityGrid grid({2, 1, 3}, {0, 1, 2, 3, 4, 5}, {});
  CHECK(grid.value(1, 0, 2) == 5);
  CHECK(grid.value(0, 0, 1) == 2);
}

TEST_CASE("a grid of several bricks has the numbers of all cells, and points between those of both sides") {
  for (const DensityGrid::Size& size : {DensityGrid::Size{7, 8, 9}, {15, 16, 17}, {1, 40, 3}}) {
    const std::vector<float> values = some_values(size);
    const DensityGrid grid(size, values, {});
    auto value = values.begin();
    for (int z = 0; z < size[2]; ++z)
      for (int y = 0; y < size[1]; ++y)
        for (int x = 0; x < size[0]; ++x) REQUIRE(grid.value(x, y, z) == *value++);
    Random random(9);
    for (int i = 0; i < 2000; ++i) {
      const Vec3 point{random.uniform(-0.1f, 1.1f), random.uniform(-0.1f, 1.1f), random.uniform(-0.1f, 1.1f)};
      const double unit[3] = {double(point.x), double(point.y), double(point.z)};
      REQUIRE(grid.at(point) == Approx(density_at(size, values, unit)).margin(1e-9));
    }
    for (int i = 0; i < 20; ++i) {
      const Vec3 origin = Vec3{0.5f, 0.5f, 0.5f} + random.in_ball() * 2.0f;
      const Ray ray{.origin = origin,
                    .direction = Vec3{random.unit(), random.unit(), random.unit()} - origin};
      CHECK(grid.amount(ray, 0, 3) ==
            Approx(amount_of(size, values, {}, ray, 0, 3)).epsilon(4e-3).margin(1e-3));
    }
  }
}

TEST_CASE("a grid keeps memory for what is not 0, and crosses the rest") {
  DensityGrid grid({1000, 1000, 1000}, {});
  const std::size_t empty = grid.bytes();
  CHECK(empty < 9e6);
  grid.set(1, 2, 3, 0);
  CHECK(grid.bytes() == empty);
  grid.set(500, 501, 502, 5);
  CHECK(grid.bytes() - empty < 20000);
  CHECK(grid.value(500, 501, 502) == 5);
  const auto middle = [](int cell) { return (float(cell) + 0.5f) / 1000; };
  const Ray ray{.origin = {middle(500), middle(501), -1}, .direction = {0, 0, 1}};
  CHECK(grid.amount(ray, 0, infinity) == Approx(5.0 / 1000).epsilon(0.01));
  CHECK(grid.at({middle(500), middle(501), middle(502)}) == Approx(5).epsilon(0.01));
  CHECK(error_text([&] { grid.set(0, 0, 0, -2); }) ==
        "a number of the grid is -2; it must be finite and >= 0");
}

TEST_CASE("what lies along a ray is asked for up to where it is enough") {
  const DensityGrid grid({30, 1, 1}, std::vector<float>(30, 2.0f), {});
  const Ray ray{.origin = {-1, 0.5f, 0.5f}, .direction = {1, 0, 0}};
  const double whole = grid.amount(ray, 0, infinity);
  CHECK(grid.amount(ray, 0, infinity, 10) == whole);
  const double part = grid.amount(ray, 0, infinity, 0.5);
  CHECK(part > 0.5);
  CHECK(part < 0.6);
}

}  // namespace twinray::test

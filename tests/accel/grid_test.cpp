// SPDX-License-Identifier: Apache-2.0
#include "accel/compact/grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/catch.h"
#include "tests/support/random.h"

namespace twinray {
namespace {

using test::Random;

constexpr float largest = 3e38f;

/// The greatest magnitude of the children's planes, times two roundings of a float.
double rounding_of(const std::vector<Extent>& children) {
  float most = 0;
  for (const Extent& child : children) most = std::max({most, std::abs(child.lower), std::abs(child.upper)});
  return std::max(most * 0x1p-22, 0x1p-126);
}

/// How far a grid's planes are from the ends of a box that is rounded outward.
double below(const Grid& grid, float at) { return double(at) - grid.plane(grid.last_below(at)); }
double above(const Grid& grid, float at) { return double(grid.plane(grid.first_above(at))) - at; }

/// A room of some size somewhere: a floor, a ceiling, and what is between them.
struct Room {
  std::vector<Extent> children;
  Extent floor, ceiling;

  explicit Room(Random& random) {
    const float extent = std::ldexp(1.0f, int(random.below(40)) - 20);
    const float place = random.below(2) == 0 ? 0.0f : random.in_cube(3 * extent).x;
    const float pad = (std::abs(place) + extent) * 4e-6f;
    floor = {place - pad, place + pad};
    ceiling = {place + extent - pad, place + extent + pad};
    children = {ceiling, floor};
    for (std::uint64_t i = random.below(7); i > 0; --i) {
      const float from = place + extent * (0.5f + 0.4f * random.in_cube().x);
      children.push_back({from, std::min(place + extent, from + extent * 0.1f)});
    }
  }
};

}  // namespace

TEST_CASE("a grid reaches over all children, and the nearest planes outside of each are found") {
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    CAPTURE(i);
    const float scale = std::ldexp(1.0f, int(random.below(250)) - 125);
    std::vector<Extent> children;
    for (std::uint64_t count = 1 + random.below(8); count > 0; --count) {
      const Vec3 a = random.in_cube(scale);
      const bool is_flat = random.below(3) == 0;
      children.push_back({std::min(a.x, a.y), is_flat ? std::min(a.x, a.y) : std::max(a.x, a.y)});
    }
    const Grid grid = fit_grid(children);
    REQUIRE(grid.step >= std::numeric_limits<float>::min());  // Some processors are set to take less for 0.
    for (const Extent& child : children) {
      const int lower = grid.last_below(child.lower), upper = grid.first_above(child.upper);
      REQUIRE(grid.plane(lower) <= child.lower);
      REQUIRE((lower == Grid::most_steps || grid.plane(lower + 1) > child.lower));
      REQUIRE(upper <= Grid::most_steps);
      REQUIRE(grid.plane(upper) >= child.upper);
      REQUIRE((upper == 0 || grid.plane(upper - 1) < child.upper));
    }
  }
}

TEST_CASE("a plane is the nearest one to itself, and not to the floats beside it") {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    // Near zero, where products and sums are rounded differently.
    const std::vector<Extent> children = {{-1 - random.in_cube().x / 2, 0}, {-0.5f, random.in_cube().y + 2}};
    const Grid grid = fit_grid(children);
    for (int steps = 1; steps < Grid::most_steps; ++steps) {
      CAPTURE(i, steps);
      const float plane = grid.plane(steps);
      REQUIRE(grid.last_below(plane) == steps);
      REQUIRE(grid.first_above(plane) == steps);
      REQUIRE(grid.last_below(std::nextafter(plane, -infinity)) == steps - 1);
      REQUIRE(grid.first_above(std::nextafter(plane, infinity)) == steps + 1);
    }
  }
}

TEST_CASE("without flat children a grid is the finest one, from end to end") {
  const std::vector<Extent> children = {{2, 5}, {-1, 3}, {1, 50}};
  const Grid grid = fit_grid(children);
  CHECK(grid.plane(0) == -1);
  CHECK(grid.plane(Grid::most_steps) >= 50);
  CHECK(std::abs(grid.step - 51.0 / Grid::most_steps) <= 1e-6);
}

TEST_CASE("a floor and a ceiling become thicker on the outside alone") {
  Random random(2);
  for (int i = 0; i < 20000; ++i) {
    CAPTURE(i);
    const Room room(random);
    const Grid grid = fit_grid(room.children);
    const double rounding = rounding_of(room.children);
    CHECK(above(grid, room.floor.upper) <= rounding);
    CHECK(below(grid, room.ceiling.lower) <= rounding);
    CHECK(grid.step <= 1.01 * (room.ceiling.upper - room.floor.lower) / (Grid::most_steps - 2));
  }
}

TEST_CASE("a single flat child becomes thicker on the side of the nearer end, wherever it lies") {
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    CAPTURE(i);
    const float at = 0.499f * (1 + random.in_cube().x);
    const Extent table = {at, at + 1e-4f};
    const std::vector<Extent> low = {{0, 0.3f}, table, {0.2f, 2}}, high = {{-1, 0.3f}, table, {0.2f, 1}};
    if (at > 0 && at + 1e-4f < 1) CHECK(above(fit_grid(low), table.upper) <= rounding_of(low));
    if (at > 0.001f) CHECK(below(fit_grid(high), table.lower) <= rounding_of(high));
  }
}

TEST_CASE("flat children side by side in the middle leave the grid as fine as it can be") {
  const Grid grid = fit_grid(std::vector<Extent>{{-1, 0.2f}, {-1e-4f, -1e-4f}, {1e-4f, 1e-4f}, {-0.2f, 1}});
  CHECK(grid.plane(0) == -1);
  CHECK(std::abs(grid.step - 2.0 / Grid::most_steps) <= 1e-7);
}

TEST_CASE("grids of the largest, the smallest and no extents reach over them") {
  const std::vector<std::vector<Extent>> cases = {{{-largest, largest}},
                                                  {{-largest, -largest}, {largest, largest}},
                                                  {{0, 0}},
                                                  {{1, 1}, {1, 1}},
                                                  {{0, 1e-45f}, {1e-45f, 1e-44f}},
                                                  {{1, std::nextafter(1.0f, 2.0f)}},
                                                  {{-1e-40f, -1e-40f}, {1, 1}},
                                                  {{largest, largest}, {0, 1e-45f}}};
  for (const std::vector<Extent>& children : cases) {
    const Grid grid = fit_grid(children);
    for (const Extent& child : children) {
      CHECK(grid.plane(grid.last_below(child.lower)) <= child.lower);
      const int upper = grid.first_above(child.upper);
      CHECK(upper <= Grid::most_steps);
      CHECK(grid.plane(upper) >= child.upper);
    }
  }
}

}  // namespace twinray

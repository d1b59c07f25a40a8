// SPDX-License-Identifier: Apache-2.0
#include "io/polygon.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/elementary.h"
#include "tests/support/catch.h"

namespace twinray {
namespace {

/// Twice the area in the plane x, y; negative where the triangle is wound clockwise.
double area2(std::span<const Vec3> p, const std::array<std::uint32_t, 3>& t) {
  const Vec3 &a = p[t[0]], &b = p[t[1]], &c = p[t[2]];
  return (double(b.x) - a.x) * (double(c.y) - a.y) - (double(b.y) - a.y) * (double(c.x) - a.x);
}

double polygon_area2(std::span<const Vec3> p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec3 &a = p[i], &b = p[(i + 1) % p.size()];
    sum += double(a.x) * b.y - double(a.y) * b.x;
  }
  return sum;
}

/// Corners around the origin at random distances: seldom convex, never crossing itself.
std::vector<Vec3> random_star(std::mt19937& random, int corners) {
  std::vector<Vec3> points;
  for (int i = 0; i < corners; ++i) {
    const float radius = 0.1f + float(random() % 1000) / 1000;
    const SinCos turn = sincos_turns(float(i) / float(corners));
    points.push_back({radius * turn.cos, radius * turn.sin, 0});
  }
  return points;
}

}  // namespace

TEST_CASE("a convex polygon becomes a fan") {
  const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  CHECK(triangulate(square) == std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("triangles of a polygon cover it once and keep its winding") {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    std::vector<Vec3> points = random_star(random, 4 + round % 20);
    if (round % 2 == 1) std::reverse(points.begin(), points.end());
    INFO("round " << round);
    const double sign = round % 2 == 1 ? -1 : 1;
    const auto triangles = triangulate(points);
    REQUIRE(triangles.size() == points.size() - 2);
    double sum = 0;
    for (const auto& t : triangles) {
      CHECK(sign * area2(points, t) > 0);
      sum += area2(points, t);
    }
    CHECK(sum == Approx(polygon_area2(points)));
  }
}

TEST_CASE("polygons without area, and ones that cross themselves, give triangles of their corners") {
  const std::vector<Vec3> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5f, 0, 0}};
  const std::vector<Vec3> bow{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<Vec3> point(6, Vec3{1, 2, 3});
  CHECK(triangulate(line).size() == 3);
  CHECK(triangulate(bow).size() == 2);
  CHECK(triangulate(point).size() == 4);
}

}  // namespace twinray

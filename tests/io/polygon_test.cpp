// SPDX-License-Identifier: Apache-2.0
#include "io/polygon.h"

#include <algorithm>
#include <cmath>
#include <map>
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

/// The same, of corners on a grid of 7 x 7 around the origin, one for each direction: at most 16.
std::vector<Vec3> grid_star(std::mt19937& random) {
  std::map<float, Vec3> by_direction;
  for (int i = 0; i < 16; ++i) {
    const float x = float(random() % 7) - 3;
    const float y = float(random() % 7) - 3;
    if (x != 0 || y != 0) by_direction[float(atan2_turns(y, x))] = {x, y, 0};
  }
  std::vector<Vec3> points;
  for (const auto& [direction, point] : by_direction) points.push_back(point);
  for (std::size_t i = 0; i < points.size(); ++i) {  // all around the origin, or it may lie outside
    const Vec3 &a = points[i], &b = points[(i + 1) % points.size()];
    if (a.x * b.y - a.y * b.x <= 0) return {};
  }
  return points;
}

/// Whether triangles have the polygon's area together, and its winding each.
void check_triangles(const std::vector<Vec3>& points) {
  const auto triangles = triangulate(points);
  REQUIRE(triangles.size() == points.size() - 2);
  const double whole = polygon_area2(points);
  double sum = 0;
  for (const auto& t : triangles) {
    CHECK(area2(points, t) * whole >= 0);
    sum += area2(points, t);
  }
  CHECK(sum == Approx(whole));
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
    for (const auto& t : triangulate(points)) CHECK(std::fabs(area2(points, t)) > 0);
    check_triangles(points);
  }
}

// Here a corner often lies on the line that would cut off an ear.
TEST_CASE("polygons of points on a small grid, where many touch, are covered once") {
  std::mt19937 random(8);
  for (int round = 0; round < 2000; ++round) {
    const std::vector<Vec3> points = grid_star(random);
    if (points.size() < 4) continue;
    INFO("round " << round);
    check_triangles(points);
  }
}

TEST_CASE("a polygon is triangulated alike in any plane") {
  std::mt19937 random(9);
  for (int round = 0; round < 50; ++round) {
    const std::vector<Vec3> flat = random_star(random, 4 + round % 10);
    std::vector<Vec3> onto_yz, onto_zx;
    for (const Vec3& p : flat) {
      onto_yz.push_back({1, p.x, p.y});
      onto_zx.push_back({p.y, 2, p.x});
    }
    CHECK(triangulate(onto_yz) == triangulate(flat));
    CHECK(triangulate(onto_zx) == triangulate(flat));
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

// Squares in some cells of a grid, in either winding: bridges pass by corners that lie on their line.
TEST_CASE("a polygon with holes is covered once, and its holes are not") {
  std::mt19937 random(10);
  for (int round = 0; round < 200; ++round) {
    const float size = 10;
    std::vector<Vec3> points{{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, 0}};
    std::vector<std::size_t> starts;
    double holes = 0;
    for (int cell = 0; cell < 25; ++cell) {
      if (random() % 3 == 0) continue;
      const float x = float(cell % 5) * 2 + 0.5f, y = float(cell / 5) * 2 + 0.5f;
      std::vector<Vec3> hole{{x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0}};
      if (random() % 2 == 0) hole.erase(hole.begin() + std::ptrdiff_t(random() % 4));
      if (random() % 2 == 0) std::reverse(hole.begin(), hole.end());
      starts.push_back(points.size());
      points.insert(points.end(), hole.begin(), hole.end());
      holes += hole.size() == 4 ? 1 : 0.5;
    }
    INFO("round " << round);
    const auto triangles = triangulate(points, starts);
    CHECK(triangles.size() == points.size() - 2 + 2 * starts.size());
    double sum = 0;
    for (const auto& t : triangles) {
      CHECK(area2(points, t) >= 0);
      sum += area2(points, t) / 2;
    }
    CHECK(sum == Approx(size * size - holes));
  }
}

TEST_CASE("a hole outside of its polygon is left out") {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 0}, {6, 5, 0}, {5, 6, 0}};
  const std::vector<std::size_t> starts{3};
  CHECK(triangulate(points, starts) == std::vector<std::array<std::uint32_t, 3>>{{2, 0, 1}});
}

TEST_CASE("a polygon of the most corners that are read is cut within a moment") {
  std::mt19937 random(11);
  check_triangles(random_star(random, int(max_polygon_corners)));
}

}  // namespace twinray

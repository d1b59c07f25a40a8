// SPDX-License-Identifier: Apache-2.0
#include "check/judge.h"

#include <cmath>
#include <limits>

#include "check/exact.h"
#include "core/error.h"
#include "tests/support/answers.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"
#include "tests/support/wide_integer.h"

namespace twinray {
namespace {

using test::downward;
using test::Random;
using test::sign;
using test::Wide;

constexpr Vec3 corner_a{0, 0, 0}, corner_b{4, 0, 0}, corner_c{0, 4, 0};

TriangleJudgement judge_corner(const Ray& ray) { return judge_triangle(ray, corner_a, corner_b, corner_c); }

bool contains(const Estimate& t, double value) { return std::fabs(t.value - value) <= t.error; }

struct IntegerVector {
  Wide x, y, z;
};
IntegerVector minus(const IntegerVector& a, const IntegerVector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Wide volume(const IntegerVector& d, const IntegerVector& p, const IntegerVector& q) {
  return d.x * (p.y * q.z - p.z * q.y) + d.y * (p.z * q.x - p.x * q.z) + d.z * (p.x * q.y - p.y * q.x);
}

IntegerVector small_integers(Random& random, int size) {
  const int x = random.between(-size, size);
  const int y = random.between(-size, size);
  const int z = random.between(-size, size);
  return {x, y, z};
}
Vec3 scaled(const IntegerVector& v, int exponent) {
  return {std::ldexp(float(v.x), exponent), std::ldexp(float(v.y), exponent),
          std::ldexp(float(v.z), exponent)};
}

LinePosition integer_position(const IntegerVector& o, const IntegerVector& d, const IntegerVector (&v)[3]) {
  const IntegerVector p = minus(v[0], o), q = minus(v[1], o), r = minus(v[2], o);
  const int signs[3] = {sign(volume(d, q, r)), sign(volume(d, r, p)), sign(volume(d, p, q))};
  const int facing = sign(volume(d, q, r) + volume(d, r, p) + volume(d, p, q));
  if (facing == 0) return LinePosition::edge_on;
  int zeros = 0;
  for (const int s : signs) {
    if (s == -facing) return LinePosition::outside;
    zeros += s == 0;
  }
  return zeros == 0 ? LinePosition::inside : zeros == 1 ? LinePosition::on_edge : LinePosition::on_vertex;
}

}  // namespace

TEST_CASE("the judge names interior, edge, vertex and outside of a triangle") {
  CHECK(judge_corner(downward(1, 1)).position == LinePosition::inside);
  CHECK(judge_corner(downward(2, 0)).position == LinePosition::on_edge);
  CHECK(judge_corner(downward(2, 2)).position == LinePosition::on_edge);
  CHECK(judge_corner(downward(4, 0)).position == LinePosition::on_vertex);
  CHECK(judge_corner(downward(-0.0f, 0)).position == LinePosition::on_vertex);
  CHECK(judge_corner(downward(0x1p-149f, 0x1p-149f)).position == LinePosition::inside);
  CHECK(judge_corner(downward(2, -0x1p-149f)).position == LinePosition::outside);
  CHECK(judge_corner(downward(2, 0x1.000002p1f)).position == LinePosition::outside);
  CHECK(judge_corner({.origin = {1, 1, 2}, .direction = {1, 0, 0}}).position == LinePosition::edge_on);
  CHECK(judge_corner({.origin = {1, 1, 0}, .direction = {1, 1, 0}}).position == LinePosition::edge_on);
  CHECK(judge_triangle(downward(1, 1), corner_a, corner_b, {8, 0, 0}).position == LinePosition::edge_on);
}

TEST_CASE("the judge places t exactly in the closed interval") {
  Ray ray = downward(1, 1);
  CHECK(contains(judge_corner(ray).t, 2));
  ray.t_max = 2;
  CHECK(judge_corner(ray).interval == IntervalPosition::at_max);
  CHECK(judge_corner(ray).hits());
  ray.t_max = 0x1.fffffep0f;
  CHECK(judge_corner(ray).interval == IntervalPosition::above);
  CHECK_FALSE(judge_corner(ray).hits());
  ray.t_min = ray.t_max = 2;
  CHECK(judge_corner(ray).interval == IntervalPosition::at_min);
  ray.t_min = ray.t_max = 0x1.000002p1f;
  CHECK(judge_corner(ray).interval == IntervalPosition::below);
  ray.t_min = 0;
  CHECK(judge_corner(ray).interval == IntervalPosition::within);
}

TEST_CASE("the judge refuses NaN and infinity, but for an endless ray") {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const Sphere sphere{{1, 1, 0}, 1};
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity}) {
    const Ray good = downward(1, 1);
    Ray rays[4] = {good, good, good, good};
    rays[0].origin.x = rays[1].direction.y = rays[2].t_min = rays[3].t_max = bad;
    for (int i = 0; i < 4; ++i) {
      INFO(bad << " in place " << i);
      if (i == 3 && bad == infinity) {
        CHECK(judge_corner(rays[i]).hits());
        CHECK(judge_sphere(rays[i], sphere).hits(0));
        continue;
      }
      CHECK_THROWS_AS(judge_corner(rays[i]), Error);
      CHECK_THROWS_AS(judge_sphere(rays[i], sphere), Error);
    }
  }
}

TEST_CASE("the judge's weights, margin and cosine are those of plane geometry") {
  const TriangleJudgement judgement = judge_corner({.origin = {1, 2, 2}, .direction = {0, 0, -3}});
  CHECK(judgement.weights[0] == Approx(0.25));
  CHECK(judgement.weights[1] == Approx(0.25));
  CHECK(judgement.weights[2] == Approx(0.5));
  CHECK(judgement.edge_distance == Approx(std::sqrt(0.5)));
  CHECK(judgement.scale == 3);
  CHECK(judgement.edge_margin_ulps() == Approx(std::sqrt(0.5) / 3 * 0x1p24));
  CHECK(judgement.cosine == Approx(1));
  CHECK(judge_corner(downward(2, -0.5f)).edge_distance == Approx(-0.5));
  CHECK(judge_corner({.origin = {0, 1, 1}, .direction = {1, 0, -1}}).cosine == Approx(std::sqrt(0.5)));
}

TEST_CASE("the judge agrees with integer arithmetic on small lattices at every scale") {
  Random random(3);
  int counts[5] = {};
  for (int i = 0; i < 40000; ++i) {
    const int size = random.between(1, 4), exponent = random.between(-140, 120);
    const IntegerVector o = small_integers(random, size), d = small_integers(random, size);
    if (d.x == 0 && d.y == 0 && d.z == 0) continue;
    const IntegerVector v[3] = {small_integers(random, size), small_integers(random, size),
                                small_integers(random, size)};
    const Ray ray{.origin = scaled(o, exponent), .direction = scaled(d, random.between(-140, 120))};
    const LinePosition expected = integer_position(o, d, v);
    ++counts[int(expected)];
    INFO("draw " << i);
    CHECK(judge_triangle(ray, scaled(v[0], exponent), scaled(v[1], exponent), scaled(v[2], exponent))
              .position == expected);
  }
  for (const int count : counts) CHECK(count > 500);
}

TEST_CASE("the judge's t holds the exact t where numbers of all sizes meet") {
  Random random(4);
  for (int i = 0; i < 20000; ++i) {
    const auto wild = [&] {
      Vec3 p = random.in_cube();
      for (int axis = 0; axis < 3; ++axis) p[axis] = std::ldexp(p[axis], random.between(-90, 60));
      return p;
    };
    Ray ray{.origin = wild(), .direction = wild()};
    const Vec3 a = wild(), b = wild(), c = wild();
    const TriangleJudgement judgement = judge_triangle(ray, a, b, c);
    if (judgement.position == LinePosition::edge_on) continue;
    // t rounded down and up to float must lie on its two sides, by the exact comparison.
    const double low = judgement.t.value - judgement.t.error, high = judgement.t.value + judgement.t.error;
    if (!(low > 0 && high < 0x1p100)) continue;
    ray.t_min = std::nextafter(float(low), 0.0f);
    ray.t_max = std::nextafter(float(high), INFINITY);
    CHECK(judge_triangle(ray, a, b, c).interval == IntervalPosition::within);
    CHECK(judgement.t.error <= judgement.t.value * 0x1p-39);
  }
}

TEST_CASE("the judge counts the roots of a sphere exactly") {
  const Sphere sphere{{0, 0, 0}, 1};
  CHECK(judge_sphere({.origin = {1, -5, 0}, .direction = {0, 3, 0}}, sphere).roots == 1);
  CHECK(judge_sphere({.origin = {0x1.fffffep-1f, -5, 0}, .direction = {0, 3, 0}}, sphere).roots == 2);
  CHECK(judge_sphere({.origin = {0x1.000002p0f, -5, 0}, .direction = {0, 3, 0}}, sphere).roots == 0);
  CHECK(judge_sphere({.origin = {1, -5, 0x1p-149f}, .direction = {0, 3, 0}}, sphere).roots == 0);
  CHECK(judge_sphere({.origin = {0, 0, 0}, .direction = {0, 3, 0}}, {{0, 0, 0}, 0}).roots == 0);
}

TEST_CASE("the judge gives both roots of a sphere and their places in the interval") {
  const Sphere sphere{{0, 0, 0}, 2};
  Ray ray{.origin = {0, 0, -6}, .direction = {0, 0, 2}, .t_min = 2, .t_max = 4};
  SphereJudgement judgement = judge_sphere(ray, sphere);
  CHECK(contains(judgement.t[0], 2));
  CHECK(contains(judgement.t[1], 4));
  CHECK(judgement.interval[0] == IntervalPosition::at_min);
  CHECK(judgement.interval[1] == IntervalPosition::at_max);
  CHECK(judgement.depth == Approx(2));
  ray.t_min = 0x1.000002p1f;
  ray.t_max = 0x1.fffffep1f;
  judgement = judge_sphere(ray, sphere);
  CHECK(judgement.interval[0] == IntervalPosition::below);
  CHECK(judgement.interval[1] == IntervalPosition::above);
  ray.t_min = 0;
  ray.t_max = INFINITY;
  ray.origin.z = 0;
  judgement = judge_sphere(ray, sphere);
  CHECK(judgement.interval[0] == IntervalPosition::below);
  CHECK(judgement.interval[1] == IntervalPosition::within);
}

TEST_CASE("a tangent's one root lies at an end of the interval, and not a float beside it") {
  const Sphere sphere{{0, 0, 0}, 1};
  Ray ray{.origin = {1, -5, 0}, .direction = {0, 1, 0}};
  const auto expect = [&](float t_min, float t_max, IntervalPosition expected) {
    ray.t_min = t_min;
    ray.t_max = t_max;
    const SphereJudgement judgement = judge_sphere(ray, sphere);
    CAPTURE(t_min, t_max);
    REQUIRE(judgement.roots == 1);
    for (const int root : {0, 1}) {
      CHECK(judgement.interval[root] == expected);
      CHECK(contains(judgement.t[root], 5));
      CHECK(judgement.hits(root) ==
            (expected != IntervalPosition::below && expected != IntervalPosition::above));
    }
  };
  const float before = std::nextafter(5.0f, 0.0f), behind = std::nextafter(5.0f, 9.0f);
  expect(5, 9, IntervalPosition::at_min);
  expect(before, 9, IntervalPosition::within);
  expect(behind, 9, IntervalPosition::below);
  expect(0, 5, IntervalPosition::at_max);
  expect(0, behind, IntervalPosition::within);
  expect(0, before, IntervalPosition::above);
  expect(5, 5, IntervalPosition::at_min);
}

TEST_CASE("a root of a sphere lies where the exact comparisons of its neighbours say") {
  Random random(5);
  for (int i = 0; i < 20000; ++i) {
    const Sphere sphere{random.in_cube(10), std::ldexp(random.unit() + 0.5f, random.between(-30, 5))};
    const Vec3 target = sphere.center + random.in_ball() * sphere.radius;
    Ray ray{.origin = random.in_ball() * std::ldexp(1.0f, random.between(0, 50))};
    ray.direction = target - ray.origin;
    const SphereJudgement judgement = judge_sphere(ray, sphere);
    for (int root = 0; root < judgement.roots; ++root) {
      const Estimate t = judgement.t[root];
      if (!(t.value > 0)) continue;
      ray.t_min = std::nextafter(float(t.value - t.error), 0.0f);
      ray.t_max = std::nextafter(float(t.value + t.error), INFINITY);
      CHECK(judge_sphere(ray, sphere).interval[root] == IntervalPosition::within);
    }
  }
}

TEST_CASE("the closest hit is judged among all shapes, ties kept") {
  Mesh near{.name = "near",
            .positions = {corner_a, corner_b, corner_c, {4, 4, 0}},
            .triangles = {{0, 1, 2}, {1, 3, 2}}};
  SphereSet behind{.name = "behind", .spheres = {{{1, 1, -5}, 1}}};
  const Geometry geometry({near, behind});
  CHECK(judge_all(geometry, downward(1, 1)).size() == 2);
  CHECK(judge_closest(geometry, downward(1, 1)).size() == 1);
  const auto on_edge = judge_closest(geometry, downward(2, 2));
  REQUIRE(on_edge.size() == 2);
  CHECK(on_edge[0].primitive == 0);
  CHECK(on_edge[1].primitive == 1);
  CHECK(judge_closest(geometry, downward(-1, 1)).empty());
  CHECK(judge_closest(Geometry(), downward(1, 1)).empty());
  Ray past = downward(1, 1);
  past.t_min = 2.5f;
  REQUIRE(judge_closest(geometry, past).size() == 1);
  CHECK(judge_closest(geometry, past)[0].mesh == 1);
  CHECK(contains(judge_closest(geometry, past)[0].t, 6));
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Where each class of differences ends, as literals: what lies just inside of a limit is explained, what lies
// just beyond it is not.
//
// The limits are 64 ulps, of 2^-24 each, of what a float test rounds on. The numbers below were worked out by
// hand from the shapes; a limit that becomes a hundredth more generous is noticed.
#include "check/oracle.h"
#include "tests/support/answers.h"
#include "tests/support/catch.h"
#include "tests/support/shapes.h"

using namespace twinray;
using namespace twinray::test;

namespace {

Mesh right_triangle(float leg, float z = 0) {
  Mesh mesh;
  add_triangle(mesh, {0, 0, z}, {leg, 0, z}, {0, leg, z});
  return mesh;
}

/// Legs of 4 along x and y from the origin of coordinates. For downward(1, 1) the largest component of vertex
/// - origin is 3 and |d . n| / L^2 = 0.5, so one ulp of t is (3 / 0.5 + t) 2^-24 = 8 * 2^-24 and 64 of them
/// are 3.052e-5; one ulp of a weight is (1 + 3 / (0.5 sqrt(32))) 2^-24, and 64 are 7.86e-6.
const Oracle& triangle() {
  static const Oracle oracle(share({right_triangle(4)}));
  return oracle;
}

Difference of_t(float t) {
  return triangle().classify(downward(1, 1), hit(2, 0.25f, 0.25f), hit(t, 0.25f, 0.25f));
}
Difference of_weight(float u) {
  return triangle().classify(downward(1, 1), hit(2, 0.25f, 0.25f), hit(2, u, 0.25f));
}
/// One engine hits at t = 2, the other misses, on a ray of this interval.
Difference of_interval(float t_min, float t_max) {
  Ray ray = downward(1, 1);
  ray.t_min = t_min;
  ray.t_max = t_max;
  return triangle().classify(ray, hit(2, 0.25f, 0.25f), miss);
}

constexpr float far_off = 100;

}  // namespace

TEST_CASE("rounding of t ends at 64 ulps") {
  CHECK(of_t(2.00003f) == Difference::rounding);
  CHECK(of_t(2.000031f) == Difference::unexplained);
  CHECK(of_t(1.99997f) == Difference::rounding);
  CHECK(of_t(1.999969f) == Difference::unexplained);
}

TEST_CASE("rounding of a weight ends at 64 ulps") {
  CHECK(of_weight(0.2500078f) == Difference::rounding);
  CHECK(of_weight(0.250008f) == Difference::unexplained);
  CHECK(of_weight(0.2499922f) == Difference::rounding);
  CHECK(of_weight(0.249992f) == Difference::unexplained);
}

TEST_CASE("rounding of a sphere's t ends at 64 ulps") {
  // Of centre - origin plus radius, 3, and of t, 1: 64 * 4 * 2^-24 = 1.526e-5.
  const Oracle oracle(share({SphereSet{"ball", {{{0, 0, 0}, 1}}}}));
  CHECK(oracle.classify(downward(0, 0), hit(1, 0, 0), hit(1.000015f, 0, 0)) == Difference::rounding);
  CHECK(oracle.classify(downward(0, 0), hit(1, 0, 0), hit(1.000016f, 0, 0)) == Difference::unexplained);
}

TEST_CASE("a ray passes an edge within 64 ulps, on either side") {
  // Beside the middle of the long edge, by 2^-0.5 of what y is off: 64 * 2 * 2^-24 at most, so y by 1.079e-5.
  const auto beside = [](float y) { return triangle().classify(downward(2, y), hit(2, 0.5f, 0.5f), miss); };
  CHECK(beside(2.0000107f) == Difference::edge);
  CHECK(beside(2.000011f) == Difference::unexplained);
  CHECK(beside(1.9999893f) == Difference::edge);
  CHECK(beside(1.999989f) == Difference::unexplained);
}

TEST_CASE("a ray passes the outline of a sphere within 64 ulps, on either side") {
  // 64 * 3 * 2^-24 = 1.144e-5.
  const Oracle oracle(share({SphereSet{"ball", {{{0, 0, 0}, 1}}}}));
  const auto beside = [&](float x) { return oracle.classify(downward(x, 0), hit(2, 0, 0), miss); };
  CHECK(beside(1.0000113f) == Difference::edge);
  CHECK(beside(1.0000116f) == Difference::unexplained);
  CHECK(beside(0.9999886f) == Difference::edge);
  CHECK(beside(0.9999884f) == Difference::unexplained);
}

TEST_CASE("a ray grazes below a cosine of 10^-4") {
  const auto of_slope = [](float slope) {
    const Ray ray{.origin = {0, 1, slope}, .direction = {1, 0, -slope}};
    return triangle().classify(ray, hit(1, 0.25f, 0.25f), miss);
  };
  CHECK(of_slope(0.99e-4f) == Difference::grazing);
  CHECK(of_slope(1.01e-4f) == Difference::unexplained);
}

TEST_CASE("a hit lies at an end of the interval within 64 ulps of t") {
  for (const float near : {2.00003f, 1.99997f}) {
    CHECK(of_interval(0, near) == Difference::interval_end);
    CHECK(of_interval(near, far_off) == Difference::interval_end);
  }
  for (const float beside : {2.000031f, 1.999969f}) {
    CHECK(of_interval(0, beside) == Difference::unexplained);
    CHECK(of_interval(beside, far_off) == Difference::unexplained);
  }
}

TEST_CASE("a triangle is tiny where its longest edge is below 64 ulps of its distance") {
  // From 1000 away 64 ulps are 3.815e-3.
  const auto of_edge = [](float longest) {
    const float leg = longest / std::sqrt(2.0f);
    const Oracle oracle(share({right_triangle(leg)}));
    const Ray ray{.origin = {leg / 4, leg / 4, 1000}, .direction = {0, 0, -1}};
    return oracle.classify(ray, hit(1000, 0.25f, 0.25f), miss);
  };
  CHECK(of_edge(3.80e-3f) == Difference::tiny);
  CHECK(of_edge(3.83e-3f) == Difference::edge);
}

TEST_CASE("weights underflow where twice the volume is below 10^-18") {
  const auto of_leg = [](float leg) {
    const Oracle oracle(share({right_triangle(leg)}));
    const Ray ray{.origin = {leg / 4, leg / 4, 2 * leg}, .direction = {0, 0, -1}};
    return oracle.classify(ray, hit(2 * leg, 0.25f, 0.25f), hit(2 * leg, 0, 0));
  };
  CHECK(of_leg(7.05e-10f) == Difference::underflow);
  CHECK(of_leg(7.10e-10f) == Difference::unexplained);
}

TEST_CASE("two hits are a tie or an overlap within 64 ulps of both") {
  // 8 * 2^-24 for each: 6.104e-5.
  const auto at_distance = [](float distance) {
    const Oracle oracle(share({right_triangle(4), right_triangle(4, -distance)}));
    Answer second = hit(2 + distance, 0.25f, 0.25f);
    second.closest.mesh = 1;
    return oracle.classify(downward(1, 1), hit(2, 0.25f, 0.25f), second);
  };
  CHECK(at_distance(6.0e-5f) == Difference::overlap);
  CHECK(at_distance(6.2e-5f) == Difference::unexplained);
}

TEST_CASE("triangles whose planes differ by a sine of 10^-5 at most overlap, others are a tie") {
  const auto at_slope = [](float slope) {
    Mesh mesh =
        right_triangle(4);  // and another one, turned about the line y = 1, through which the ray goes
    add_triangle(mesh, {0, 0, -slope}, {4, 0, -slope}, {0, 4, 3 * slope});
    const Oracle oracle(share({mesh}));
    return oracle.classify(downward(1, 1), hit(2, 0.25f, 0.25f), hit(2, 0.25f, 0.25f, 1));
  };
  CHECK(at_slope(0) == Difference::overlap);
  CHECK(at_slope(0.98e-5f) == Difference::overlap);
  CHECK(at_slope(1.02e-5f) == Difference::tie);
  CHECK(at_slope(1e-3f) == Difference::tie);
  CHECK(at_slope(0.5f) == Difference::tie);
}

TEST_CASE("two engines that pass over the same clear hit are not excused, wherever in its triangle it lies") {
  // Behind it both are defensible: the ray passes a hair beside the edge of the farther triangle.
  for (const auto& [x, y] : {std::pair{0.1f, 0.1f}, {3.8f, 0.1f}, {0.1f, 3.8f}, {1.9f, 1.9f}, {1.0f, 1.0f}}) {
    CAPTURE(x, y);
    Mesh mesh = right_triangle(4);
    add_triangle(mesh, {x, y - 50, -1}, {x, y + 50, -1}, {x - 50, y, -1});
    Mesh alone;
    add_triangle(alone, {x, y - 50, -1}, {x, y + 50, -1}, {x - 50, y, -1});
    const Answer behind = hit(3, 0.5f, 0, 1), first = hit(3, 0.5f, 0, 0);
    CHECK(Oracle(share({alone})).classify(downward(x, y), first, miss) == Difference::edge);
    CHECK(Oracle(share({mesh})).classify(downward(x, y), behind, miss) == Difference::unexplained);
  }
}

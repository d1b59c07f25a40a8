// SPDX-License-Identifier: Apache-2.0
// Each class of differences, on two triangles and made-up answers.
#include "check/oracle.h"

#include <cmath>

#include "tests/support/answers.h"
#include "tests/support/catch.h"
#include "tests/support/shapes.h"

using namespace twinray;
using namespace twinray::test;

namespace {

/// The square [0, 4]^2 at z = 0 in two triangles that meet on its diagonal, and one triangle below.
std::shared_ptr<const Geometry> square() {
  Mesh mesh;
  add_triangle(mesh, {0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  add_triangle(mesh, {4, 0, 0}, {4, 4, 0}, {0, 4, 0});
  add_triangle(mesh, {-9, -9, -1}, {99, -9, -1}, {-9, 99, -1});
  return share({mesh});
}

}  // namespace

TEST_CASE("equal bits are identical, and a few ulps are rounding") {
  const Oracle oracle(square());
  const Answer exact = hit(2, 0.25f, 0.25f, 0);
  CHECK(oracle.classify(downward(1, 1), exact, exact) == Difference::identical);
  CHECK(oracle.classify(downward(1, 1), exact, hit(0x1.000004p1f, 0.25f, 0.2500001f, 0)) ==
        Difference::rounding);
  CHECK(oracle.classify(downward(1, 1), exact, hit(2.001f, 0.25f, 0.25f, 0)) == Difference::unexplained);
  CHECK(oracle.classify(downward(1, 1), exact, hit(2, 0.25f, 0.26f, 0)) == Difference::unexplained);
}

TEST_CASE("both sides of a shared edge are a tie, and a ray beside it is an edge") {
  const Oracle oracle(square());
  const Answer first = hit(2, 0.5f, 0.5f, 0), second = hit(2, 0, 0.5f, 1);
  CHECK(oracle.classify(downward(2, 2), first, second) == Difference::tie);
  CHECK(oracle.classify(downward(2, 0x1.000004p1f), first, second) == Difference::edge);
  CHECK(oracle.classify(downward(2, 2.01f), first, second) == Difference::unexplained);
}

TEST_CASE("a miss on an outer edge is an edge, a miss of the inside is unexplained") {
  const Oracle oracle(square());
  const Answer edge = hit(2, 0.5f, 0, 0), behind = hit(3, 0.1018519f, 0.08333334f, 2);
  CHECK(oracle.classify(downward(2, 0), edge, behind) == Difference::edge);
  CHECK(oracle.classify(downward(2, 0), edge, miss) == Difference::unexplained);
  CHECK(oracle.classify(downward(2, 1), hit(2, 0.5f, 0.25f, 0), behind) == Difference::unexplained);
  Ray no_farther = downward(2, 0);
  no_farther.t_max = 2.5f;
  CHECK(oracle.classify(no_farther, edge, miss) == Difference::edge);
}

TEST_CASE("a hit exactly at an end of the interval may be missed") {
  const Oracle oracle(square());
  Ray ray = downward(1, 1);
  ray.t_max = 2;
  CHECK(oracle.classify(ray, hit(2, 0.25f, 0.25f, 0), miss) == Difference::interval_end);
  ray.t_max = 2.5f;
  CHECK(oracle.classify(ray, hit(2, 0.25f, 0.25f, 0), miss) == Difference::unexplained);
}

TEST_CASE("a hit of an invalid ray is unexplained") {
  const Oracle oracle(square());
  Ray ray = downward(1, 1);
  ray.direction.x = std::nanf("");
  CHECK(oracle.classify(ray, miss, miss) == Difference::identical);
  CHECK(oracle.classify(ray, hit(2, 0.25f, 0.25f, 0), miss) == Difference::unexplained);
}

TEST_CASE("any hit must be right where closest hits agree") {
  const Oracle oracle(square());
  const Answer found = hit(2, 0.25f, 0.25f, 0);
  Answer contradicting = found;
  contradicting.any = false;
  CHECK(oracle.classify(downward(1, 1), found, contradicting) == Difference::unexplained);
  Ray ray = downward(1, 1);
  ray.t_max = 2;
  CHECK(oracle.classify(ray, found, contradicting) == Difference::interval_end);
}

TEST_CASE("two clear hits in one plane are an overlap") {
  Mesh mesh;
  add_triangle(mesh, {0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  add_triangle(mesh, {0, 0, 0}, {0, 3, 0}, {3, 0, 0});
  const Oracle oracle(share({mesh}));
  CHECK(oracle.classify(downward(1, 1), hit(2, 0.25f, 0.25f, 0), hit(2, 0.3333333f, 0.3333333f, 1)) ==
        Difference::overlap);
}

TEST_CASE("a triangle in whose plane the ray lies may be met or missed") {
  const Oracle oracle(square());
  const Ray along{.origin = {-1, 1, 0}, .direction = {1, 0, 0}};
  CHECK(oracle.classify(along, hit(1, 0, 0.25f, 0), miss) == Difference::grazing);
  const Ray above{.origin = {-1, 1, 0.1f}, .direction = {1, 0, 0}};
  CHECK(oracle.classify(above, hit(1, 0, 0.25f, 0), hit(2, 0, 0.25f, 1)) == Difference::grazing);
}

TEST_CASE("weights that underflow are a class of their own") {
  Mesh mesh;
  add_triangle(mesh, {0, 0, 0}, {4e-10f, 0, 0}, {0, 4e-10f, 0});
  const Oracle oracle(share({mesh}));
  const Ray ray{.origin = {1e-10f, 1e-10f, 2e-10f}, .direction = {0, 0, -1}};
  CHECK(oracle.classify(ray, hit(2e-10f, 0.25f, 0.25f, 0), hit(2e-10f, 0, 0, 0)) == Difference::underflow);
  CHECK(oracle.classify(ray, hit(2e-10f, 0.25f, 0.25f, 0), hit(3e-10f, 0, 0, 0)) == Difference::unexplained);
}

TEST_CASE("the outline of a sphere may be met or missed, its inside may not") {
  const Oracle oracle(share({SphereSet{"ball", {{{0, 0, 0}, 1}}}}));
  CHECK(oracle.classify(downward(1, 0), hit(2, 0, 0, 0), miss) == Difference::edge);
  CHECK(oracle.classify(downward(0.9f, 0), hit(1.56411f, 0, 0, 0), miss) == Difference::unexplained);
}

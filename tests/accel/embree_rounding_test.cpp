// SPDX-License-Identifier: Apache-2.0
// What Embree's own box test must be given so that it loses no canonical hit: boxes, and the ends of
// intervals.
#include "accel/embree/rounding.h"

#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/random.h"

using namespace twinray;
using namespace twinray::test;

namespace {

constexpr double unit_roundoff = 0x1p-24;

Aabb random_box(Random& random, float size) {
  Aabb box;
  box.extend(random.in_cube(size));
  box.extend(random.in_cube(size));
  return box;
}

}  // namespace

TEST_CASE("a box padded for Embree holds what the canonical test accepts, seen from all origins in reach") {
  // In units of u (A + O), A the scene's size and O the origin's distance: by how much the canonical test may
  // see a shape beside its place, and Embree a plane.
  constexpr double canonical_error = 6, embree_error = 7;
  Random random(71);
  for (int i = 0; i < 20000; ++i) {
    const float size = std::ldexp(1 + random.unit(), random.between(-100, 38));
    const Aabb box = random_box(random, size), padded = embree::padded_for_embree(box, size);
    const double origin = double(size) * double(embree::reach);
    const double away = (canonical_error + embree_error) * unit_roundoff * (double(size) + origin);
    INFO("draw " << i << " size " << size);
    for (int axis = 0; axis < 3; ++axis) {
      REQUIRE(double(padded.lower[axis]) <= double(box.lower[axis]) - away);
      REQUIRE(double(padded.upper[axis]) >= double(box.upper[axis]) + away);
    }
  }
}

TEST_CASE("the ends that Embree is told lie outside of an interval by more than its parameters are off") {
  // Of one plane, Embree's parameter and the canonical one differ by up to 32 u.
  constexpr double difference = 32 * unit_roundoff;
  Random random(72);
  for (int i = 0; i < 20000; ++i) {
    const float t = std::ldexp(1 + random.unit(), random.between(-80, 80));
    INFO("draw " << i << " t " << t);
    REQUIRE(double(embree::told_t_max(t)) >= double(t) * (1 + difference));
    REQUIRE(double(embree::told_t_min(t)) <= double(t) * (1 - difference));
    REQUIRE(double(embree::told_t_max(t)) <= double(t) * 1.0001);  // It still culls.
    REQUIRE(double(embree::told_t_min(t)) >= double(t) * 0.9999);
  }
  CHECK(embree::told_t_min(0) == 0);
  CHECK(std::isinf(embree::told_t_max(Aabb::infinity)));
}

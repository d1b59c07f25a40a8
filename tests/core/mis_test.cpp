// SPDX-License-Identifier: Apache-2.0
#include "core/mis.h"

#include <limits>

#include "core/light_set.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

namespace twinray::test {

TEST_CASE("the weights of two ways of sampling add up to 1, by the squares of their densities") {
  CHECK(power_heuristic(1, 1) == 0.5f);
  CHECK(power_heuristic(3, 1) == Approx(0.9));
  CHECK(power_heuristic(1, 0) == 1);
  for (const float other : {1e-30f, 1e-3f, 0.7f, 5.0f, 1e20f, 1e38f}) {
    CAPTURE(other);
    CHECK(power_heuristic(2, other) + power_heuristic(other, 2) == Approx(1));
  }
  CHECK(power_heuristic(1e-30f, 1e30f) == 0);
}

TEST_CASE("a zone is what lies within a distance of a box") {
  const Zone zone{{{0, 0, 0}, {2, 1, 1}}, 0.25f};
  CHECK(zone.contains({1, 0.5f, 0.5f}));
  CHECK(zone.contains({2.49f, 1, 0}));
  CHECK_FALSE(zone.contains({2.5f, 1, 0}));
  CHECK_FALSE(zone.contains({2.4f, 1.4f, 0}));
  CHECK_FALSE(zone.contains({-0.6f, 0, 0}));
  CHECK_FALSE(Zone{}.contains({0, 0, 0}));
  CHECK(Zone{{{0, 0, 0}, {0, 0, 0}}, std::numeric_limits<float>::infinity()}.contains({1e12f, -1e12f, 0}));
}

TEST_CASE("mesh lights and environments have zones, spheres and delta lights have none") {
  Scene scene = scene_of(floor_square(5, -1), {0.5f, 0.5f, 0.5f}, {0, 1, 5}, {0, 0, 0});
  add_lamp(scene, floor_square(1, 1), {1, 1, 1}, EmissionSide::both);
  add_lamp(scene, SphereSet{"ball", {{{0, 3, 0}, 0.5f}}}, {1, 1, 1}, EmissionSide::both);
  add_light(scene, PointLight{{0, 0, 0}, {1, 1, 1}, {}});
  const LightSet lights(scene);
  CHECK(lights.zone(0).contains({0, 1 - 1.41f, 0}));  // Half of the diagonal is the root of 2.
  CHECK_FALSE(lights.zone(0).contains({0, 1 - 1.42f, 0}));
  CHECK_FALSE(lights.zone(1).contains({0, 3, 0}));
  CHECK_FALSE(lights.zone(2).contains({0, 0, 0}));
  CHECK(lights.is_in_a_zone({0, 1, 0}));
  CHECK_FALSE(lights.is_in_a_zone({0, 3, 0}));
  add_light(scene, EnvironmentLight{std::make_shared<Image>(2, 1)});
  CHECK(LightSet(scene).is_in_a_zone({0, 3, 0}));
}

}  // namespace twinray::test

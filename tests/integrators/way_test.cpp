// SPDX-License-Identifier: Apache-2.0
#include "integrators/way.h"

#include <cmath>

#include "tests/support/catch.h"

namespace twinray::test {
namespace {

Scene tea_and_milk() {
  Scene scene;
  scene.materials = {{.name = "tea", .model = Interface{}, .interior = {.absorption = {1, 1, 1}}},
                     {.name = "milk", .model = Interface{}, .interior = {.scattering = {2, 2, 2}}}};
  return scene;
}

Interiors within(std::uint32_t material) {
  Interiors interiors;
  interiors.enter(material);
  return interiors;
}

/// Along a direction of length 2.
Ray some_ray() { return {.origin = {1, 0, 0}, .direction = {0, 0, -2}, .t_min = 0.5f}; }

}  // namespace

TEST_CASE("a way without a flight is dimmed by media that scatter as by those that absorb") {
  const Scene scene = tea_and_milk();
  for (const std::uint32_t medium : {0u, 1u}) {
    Way way{some_ray(), {}, within(medium)};
    CHECK(way.goes_on(scene, 1.5f));
    CHECK(way.weight().g == Approx(std::exp(medium == 0 ? -2.0 : -4.0)).epsilon(1e-5));
  }
}

TEST_CASE("a way with a flight is scattered where that ends, in media that scatter alone") {
  const Scene scene = tea_and_milk();
  Way way{some_ray(), {}, within(0)};
  way.flight.emplace(Rgb{1, 1, 1}, 0.25f);
  CHECK(way.goes_on(scene, 1));
  CHECK(way.weight().r == Approx(std::exp(-1.0)).epsilon(1e-5));
  way.ray.t_min = 1;
  way.interiors = within(1);
  // The draw lies three quarters into the third of all draws that is the first channel's.
  const double depth = -std::log(0.25), length = depth / 2;
  CHECK_FALSE(way.goes_on(scene, 1 + 2));
  CHECK(way.is_scattered);
  CHECK(way.t_scattered() == Approx(1 + length / 2).epsilon(1e-4));
  CHECK(way.scattered_at().z == Approx(-2 - length).epsilon(1e-4));
  CHECK(way.weight().r == Approx(std::exp(-1.0)).epsilon(1e-4));
}

}  // namespace twinray::test

// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/cloud.h"

#include "core/noise.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"

namespace twinray::test {
namespace {

const Aabb unit_box{{0, 0, 0}, {1, 1, 1}};

}  // namespace

TEST_CASE("a cloud is full at its bottom and nothing at its top, and noise in between") {
  const PbrtCloud cloud;
  Random random(2);
  int thin = 0, thick = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p{random.unit(), random.unit(), random.unit()};
    const float density = cloud.at(p);
    CHECK(density >= 0);
    CHECK(density <= 1);
    CHECK(cloud.at({p.x, -0.01f * p.y, p.z}) == 1);
    CHECK(cloud.at({p.x, 1, p.z}) == 0);
    const float above = cloud.at({p.x, 0.5f + 0.4f * p.y, p.z});
    thin += above == 0, thick += above > 0.5f;
  }
  CHECK(thin > 100);
  CHECK(thick > 20);
  // Without wisps it is the sum of five octaves.
  const PbrtCloud smooth{.density = 0.5f, .wispiness = 0, .frequency = 2};
  const Vec3 p{0.3f, 0.7f, 0.2f};
  float sum = 0, strength = 0.5f, fineness = 1;
  for (int i = 0; i < 5; ++i, strength /= 2, fineness *= 1.99f) sum += strength * noise(p * 2 * fineness);
  CHECK(smooth.at(p) == Approx(std::max(0.0f, std::min(1.0f, 0.3f * 4.5f * 0.5f * sum))).margin(1e-6));
  int torn = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 place{random.unit(), 0.5f + 0.4f * random.unit(), random.unit()};
    torn += PbrtCloud{.wispiness = 2}.at(place) != PbrtCloud{.wispiness = 0}.at(place);
  }
  CHECK(torn > 100);
}

TEST_CASE("a cloud's grid has as many cells as its waves need, up to 192, and its values in their middles") {
  const PbrtCloud cloud{.frequency = 0.5f};
  const Aabb box{{0, 0.25f, 0}, {1, 0.75f, 20}};
  const DensityGrid grid =
      cloud_grid(cloud, box, Transform::scaling(1, 2, 0.05) * Transform::translation(0, -0.25, 0));
  CHECK(grid.size() == DensityGrid::Size{19, 9, 192});
  for (const auto& [x, y, z] : {std::array{0, 0, 0}, {18, 8, 191}, {7, 5, 100}}) {
    const Vec3 middle{(float(x) + 0.5f) / 19, 0.25f + 0.5f * (float(y) + 0.5f) / 9,
                      20 * (float(z) + 0.5f) / 192};
    CHECK(grid.value(x, y, z) == Approx(cloud.at(middle)).margin(1e-4));
    if (x == 7) CHECK(grid.at(middle) == Approx(cloud.at(middle)).margin(1e-3));
  }
  CHECK(cloud_grid({.frequency = 0}, unit_box, {}).size() == DensityGrid::Size{8, 8, 8});
}

}  // namespace twinray::test

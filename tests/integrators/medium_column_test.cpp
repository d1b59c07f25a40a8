// SPDX-License-Identifier: Apache-2.0
#include "integrators/medium_column.h"

#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/random.h"

namespace twinray::test {

TEST_CASE("a column of an even medium is as long as the way, and one of a grid as dense") {
  Scene scene;
  scene.densities = {std::make_shared<const DensityGrid>(DensityGrid::Size{1, 1, 1}, std::vector<float>{4},
                                                         Transform::scaling(0.25, 0.25, 0.25))};
  const Interior even{.absorption = {1, 1, 1}}, uneven{.absorption = {1, 1, 1}, .density = 0};
  // Through the middle of a cube of side 4, whose density falls from 4 to half of that at its faces.
  const Ray ray{.origin = {2, 2, -2}, .direction = {0, 0, 2}, .t_min = 0.5f};
  CHECK(MediumColumn(scene, even, ray, 2.5f).amount() == 4);
  CHECK(MediumColumn(scene, even, ray, 2.5f).reach(3).distance == 3);
  CHECK(MediumColumn(scene, even, ray, 2.5f).reach(4).distance == std::numeric_limits<float>::infinity());
  CHECK(MediumColumn(scene, even, ray, 2.5f).reach(9).amount == 4);
  CHECK(MediumColumn(scene, uneven, ray, 9).reach(13).amount == Approx(3 * 4));
  CHECK(MediumColumn(scene, uneven, ray, 2).amount() == Approx(3 * 2));
  CHECK(MediumColumn(scene, uneven, ray, 9).amount() == Approx(3 * 4));
  CHECK(MediumColumn(scene, uneven, ray, 9).reach(6).distance == Approx(1 + 2));
  CHECK(MediumColumn(scene, uneven, ray, 9).reach(13).distance == std::numeric_limits<float>::infinity());
}

TEST_CASE("a ray that is cut behind a way is no shorter than the way, and hardly longer") {
  Random random(3);
  const Scene scene;
  const Interior even{.absorption = {1, 1, 1}};
  for (int i = 0; i < 100000; ++i) {
    const float distance = std::exp(20 * random.unit() - 10);
    const Ray ray{.direction = random.in_ball() * std::exp(10 * random.unit() - 5),
                  .t_min = i % 2 == 0 ? 0 : random.unit() * 100};
    const float t = t_beyond(ray, distance), amount = MediumColumn(scene, even, ray, t).amount();
    CHECK(amount >= distance);
    CHECK(amount <= distance * 1.00001f + 1e-6f * t * length(ray.direction));
  }
  const Ray ray{.direction = {0, 0, 2}};
  CHECK(t_beyond(ray, std::numeric_limits<float>::infinity()) == std::numeric_limits<float>::infinity());
}

}  // namespace twinray::test

// SPDX-License-Identifier: Apache-2.0
#include "integrators/medium_column.h"

#include "tests/support/catch.h"

namespace twinray::test {

TEST_CASE("a column of an even medium is as long as the way, and one of a grid as dense") {
  Scene scene;
  scene.densities = {std::make_shared<const DensityGrid>(DensityGrid::Size{1, 1, 1}, std::vector<float>{4},
                                                         Transform::scaling(0.25, 0.25, 0.25))};
  const Interior even{.absorption = {1, 1, 1}}, uneven{.absorption = {1, 1, 1}, .density = 0};
  // Through the middle of a cube of side 4, whose density falls from 4 to half of that at its faces.
  const Ray ray{.origin = {2, 2, -2}, .direction = {0, 0, 2}, .t_min = 0.5f};
  CHECK(MediumColumn(scene, even, ray, 2.5f).amount() == 4);
  CHECK(MediumColumn(scene, even, ray, 2.5f).reach(3) == 3);
  CHECK(MediumColumn(scene, even, ray, 2.5f).reach(4) == std::numeric_limits<float>::infinity());
  CHECK(MediumColumn(scene, uneven, ray, 2).amount() == Approx(3 * 2));
  CHECK(MediumColumn(scene, uneven, ray, 9).amount() == Approx(3 * 4));
  CHECK(MediumColumn(scene, uneven, ray, 9).reach(6) == Approx(1 + 2));
  CHECK(MediumColumn(scene, uneven, ray, 9).reach(13) == std::numeric_limits<float>::infinity());
}

}  // namespace twinray::test

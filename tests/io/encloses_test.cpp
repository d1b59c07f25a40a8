// SPDX-License-Identifier: Apache-2.0
#include "io/encloses.h"

#include "tests/support/catch.h"
#include "tests/support/meshes.h"
#include "tests/support/random.h"

namespace twinray::test {

TEST_CASE("closed shapes enclose what is within them, and nothing else") {
  const Mesh ball = icosphere_mesh(2), box = box_mesh();
  const SphereSet spheres{"", {{{0, 0, 0}, 0.5f}, {{3, 0, 0}, 1}}};
  Random random(4);
  for (int i = 0; i < 500; ++i) {
    const Vec3 point = random.in_ball() * 1.7f;
    CHECK(encloses(box, point) == (max_abs(point) < 1));
    const float distance = length(point);
    if (distance < 0.95f || distance > 1) CHECK(encloses(ball, point) == (distance < 1));
    CHECK(encloses(spheres, point) == (distance < 0.5f));
  }
  CHECK(encloses(spheres, {3.5f, 0, 0.5f}));
  CHECK_FALSE(encloses(spheres, {1, 0, 0}));
  CHECK_FALSE(encloses(SphereSet{}, {0, 0, 0}));
  CHECK_FALSE(encloses(Mesh{}, {0, 0, 0}));
}

TEST_CASE("a sheet encloses nothing that its box does not") {
  const Mesh sheet{.name = "", .positions = {{-9, 0, -9}, {9, 0, -9}, {0, 0, 9}}, .triangles = {{0, 1, 2}}};
  CHECK_FALSE(encloses(sheet, {0, 1, 0}));
  CHECK_FALSE(encloses(sheet, {0, -1, 0}));
}

}  // namespace twinray::test

// SPDX-License-Identifier: Apache-2.0
#include "check/ceilings.h"
#include "check/scene_crosscheck.h"
#include "io/scene_file.h"
#include "tests/support/catch.h"

namespace twinray::test {

TEST_CASE("nothing is unexplained and no ceiling is passed on the well-known scenes") {
  for (const char* name : {"meshedit/cow.dae", "sky/CBbunny.dae", "sky/CBlucy.dae", "sky/CBdragon.dae"}) {
    INFO(name);
    const Scene scene = load_scene(TWINRAY_SCENES "/cs184/" + std::string(name)).scene;
    const SceneCrosscheck result =
        crosscheck_scene(scene, {.engines = default_crosscheck_engines(), .rays = 20000});
    CHECK(result.report.unexplained() == 0);
    CHECK(passed_ceilings(result.report).empty());
  }
}

}  // namespace twinray::test

// SPDX-License-Identifier: Apache-2.0
// CS184's program on CS184's own scenes.
#include <fmt/format.h>

#include "tests/support/catch.h"
#include "tests/support/cs184_scene.h"

namespace twinray::test {
namespace {

const std::string sky = TWINRAY_SCENES "/cs184/sky/";

ProcessResult run(const TemporaryFolder& folder, const std::string& options, const std::string& scene) {
  return run_shell(fmt::format("cd '{}' && '{}' {} '{}'", folder.path().string(), TWINRAY_PATHTRACER, options,
                               sky + scene));
}

double mean_of(const std::string& options, const std::string& scene) {
  const TemporaryFolder folder;
  const ProcessResult result = run(folder, options + " -f a.exr", scene);
  if (result.exit_code != 0) throw Error(result.err);
  return mean_luminance(read_image(folder.file("a.exr")));
}

}  // namespace

TEST_CASE("a command line of CS184's handouts runs unchanged") {
  const TemporaryFolder folder;
  const ProcessResult result = run(folder, "-t 8 -s 2 -l 2 -m 6 -r 48 36 -f bunny.png", "CBbunny.dae");
  REQUIRE(result.exit_code == 0);
  CHECK(result.out.find("[PathTracer] Building BVH from 28588 primitives... Done! (") != std::string::npos);
  CHECK(result.err == fmt::format("[PathTracer] Input scene file: {}CBbunny.dae\n"
                                  "[PathTracer] Rendering using 8 threads\n"
                                  "[PathTracer] Saving to file: bunny.png... Done!\n",
                                  sky));
  CHECK(read_image(folder.file("bunny.png")).width == 48);
  CHECK(read_image(folder.file("bunny_rate.png")).width == 48);
}

TEST_CASE("light and hemisphere sampling converge to one picture of CS184's rooms") {
  // A million and a half samples, of which one in forty finds the light: known to a part in a hundred.
  const std::string options = "-t 2 -r 400 300 -p 184 138 32 24 -s 2048 -a 2048 0 --accel=auto ";
  for (const char* scene : {"CBspheres_lambertian.dae", "CBbunny.dae"}) {
    const double lights = mean_of(options, scene);
    CHECK(mean_of(options + "-H", scene) == Approx(lights).epsilon(0.03));
  }
}

}  // namespace twinray::test

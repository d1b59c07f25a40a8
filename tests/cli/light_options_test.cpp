// SPDX-License-Identifier: Apache-2.0
// Options of integrators, and limits of bounces.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "cli/no_effect.h"
#include "cli/render_command_line.h"
#include "tests/support/catch.h"

namespace twinray::test {
namespace {

RenderArguments parse_light(std::vector<std::string> words, const std::string& scene = "scene.dae") {
  words.push_back(scene);
  return parse_render_arguments(words);
}

std::string no_light_effect(const std::vector<std::string>& words, const std::string& scene = "scene.dae") {
  return fmt::format("{}", fmt::join(parse_light(words, scene).without_effect, "\n"));
}

}  // namespace

TEST_CASE("limits of bounces are none unless given, and have no effect on paths that are no longer") {
  const BounceLimits limits =
      parse_light({"-m", "9", "--diffuse-bounces=1", "--glossy-bounces=2", "--transmission-bounces=3"})
          .path.limits;
  CHECK(limits.diffuse == 1);
  CHECK(limits.glossy == 2);
  CHECK(limits.transmission == 3);
  CHECK_FALSE(parse_light({}).path.limits.are_any());
  CHECK(no_light_effect({"-m", "4", "--glossy-bounces=3"}) ==
        "--glossy-bounces: no effect, for paths of 4 bounces make no more");
  CHECK(no_light_effect({"-m", "4", "--glossy-bounces=2"}).empty());
  CHECK(no_light_effect({"--integrator=normals", "--diffuse-bounces=2"}) ==
        "--diffuse-bounces: no effect, for --integrator=normals does not ask for the scene's light");
  // A pbrt scene may state its own depth.
  CHECK(no_light_effect({"--glossy-bounces=9"}, "scene.pbrt").empty());
  CHECK_FALSE(no_light_effect({"--glossy-bounces=9"}).empty());
}

TEST_CASE("limits of bounces have no effect on direct light alone, whatever depth the scene states") {
  for (const std::string direct : {"--integrator=direct", "--bounces=direct"})
    for (const std::string option : {"--diffuse-bounces", "--glossy-bounces", "--transmission-bounces"})
      for (const std::string scene : {"scene.dae", "scene.pbrt"}) {
        CAPTURE(direct, option, scene);
        CHECK(no_light_effect({direct, option + "=2"}, scene) ==
              option + ": no effect, for paths of 1 bounces make no more");
      }
  CHECK(no_light_effect({"--bounces=indirect", "--diffuse-bounces=2"}, "scene.pbrt").empty());
}

TEST_CASE("direct light alone is not longer for a greater depth") {
  CHECK(no_light_effect({"--bounces=direct", "-m", "9"}) ==
        "--max-depth: no effect, for --bounces=direct shows light of one bounce");
  CHECK(no_light_effect({"--bounces=direct", "-m", "1"}) ==
        "--bounces: no effect, for no other light than direct light is computed");
  CHECK(no_light_effect({"--bounces=direct"}).empty());
  CHECK(no_light_effect({"--bounces=indirect", "-m", "9"}).empty());
}

TEST_CASE("the furnace takes a depth and no light, ambient occlusion a distance") {
  CHECK(no_light_effect({"--integrator=furnace", "--default-light"}) ==
        "--default-light: no effect, for --integrator=furnace does not ask for the scene's light");
  CHECK(no_light_effect({"--integrator=furnace", "-m", "3"}).empty());
  CHECK(no_light_effect({"--integrator=furnace", "--texture-filter=nearest"}).empty());
  CHECK(no_light_effect({"--integrator=ambient-occlusion", "--texture-filter=nearest"}).empty());
  CHECK(no_light_effect({"--integrator=normals", "--texture-filter=nearest"}) ==
        "--texture-filter: no effect, for --integrator=normals does not ask for the scene's materials");
  CHECK(no_light_effect({"--ao-distance=2"}) ==
        "--ao-distance: no effect, for --integrator=ambient-occlusion alone looks around");
  CHECK_THROWS_WITH(parse_light({"-H", "--direct=lights"}),
                    "-H is --direct=hemisphere, and --direct says another thing");
  CHECK(parse_light({"--direct=hemisphere", "-H"}).path.direct == DirectMethod::hemisphere);
  CHECK(parse_light({"--integrator=ambient-occlusion", "--ao-distance=2"}).occlusion_distance == 2);
  CHECK_THROWS_WITH(parse_light({"--integrator=ambient-occlusion", "--ao-distance=0"}),
                    "--ao-distance: \"0\" is not a number from 1e-12 to inf");
  CHECK(std::isinf(parse_light({"--integrator=ambient-occlusion", "--ao-distance=inf"}).occlusion_distance));
}

TEST_CASE("both lamps are kept where there are two, and else that has no effect") {
  SceneSummary summary;
  CHECK(options_without_effect(summary, parse_light({"--keep-both-lamps"})) ==
        Words{"--keep-both-lamps: no effect, for the scene has no lamp that is given twice"});
  CHECK(options_without_effect(summary, parse_light({})).empty());
  summary.has_double_lamps = true;
  CHECK(options_without_effect(summary, parse_light({"--keep-both-lamps"})).empty());
}

}  // namespace twinray::test

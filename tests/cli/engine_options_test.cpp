// SPDX-License-Identifier: Apache-2.0
// Options of engines, and which instruction set computes.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/render_command_line.h"
#include "cli/render_scene.h"
#include "tests/support/arguments.h"
#include "tests/support/catch.h"
#include "tests/support/own_scenes.h"

namespace twinray::test {

TEST_CASE("the tree of Moller and Trumbore's test is binary, whatever is asked for") {
  const auto parsed = [](const std::string& option) {
    return parse_render_arguments({"a.dae", "--accel=bvh", "--triangle-test=moller-trumbore", option});
  };
  const auto vain = [&](const std::string& option) {
    return fmt::format("{}", fmt::join(parsed(option).without_effect, "\n"));
  };
  CHECK(vain("--max-leaf-size=16") == "");
  CHECK(parsed("--max-leaf-size=16").build.bvh_width == 2);
  CHECK(vain("--bvh-width=8") ==
        "--bvh-width: no effect, for the tree of --triangle-test=moller-trumbore is binary");
  CHECK(vain("--memory-mode=compact") ==
        "--memory-mode: no effect, for the bvh is binary; --bvh-width=8 takes it");
}

TEST_CASE(
    "the instruction set is that of trees, paths and camera rays, and a wrong one names the right ones") {
  CHECK(parse({}).build.simd == "best");
  CHECK(parse({}).render.simd == "best");
  for (const Backend backend : available_backends()) {
    const RenderArguments arguments = parse({"--accel=" + backend_name(backend), "--simd=scalar"});
    CHECK(arguments.build.simd == "scalar");
    CHECK(arguments.render.simd == "scalar");
    CHECK(arguments.without_effect.empty());
  }
  CHECK(message_of({"--accel=bvh", "--simd=none"}).find("--simd: there is no \"none\"; valid are best, ") ==
        0);
}

TEST_CASE("paths and camera rays are made by the instruction set that is asked for, or none") {
  const Scene scene = load_scene(box_scene).scene;
  for (const char* integrator : {"path", "direct"}) {
    RenderArguments arguments = parse({std::string("--integrator=") + integrator, "--simd=scalar"});
    CHECK_NOTHROW(make_integrator(arguments, scene));
    arguments.render.simd = "mmx";
    CHECK_THROWS_WITH(make_integrator(arguments, scene),
                      Catch::StartsWith("there is no instruction set \"mmx\" on this machine; valid are "));
  }
  RenderArguments arguments = parse({"--integrator=normals", "-r", "4", "3"});
  const auto accelerator = build_accelerator(Backend::bvh, scene.geometry);
  arguments.render.simd = "mmx";
  CHECK_THROWS_WITH(render(scene, *accelerator, *make_integrator(arguments, scene), arguments.render),
                    Catch::StartsWith("there is no instruction set \"mmx\" on this machine; valid are "));
}

TEST_CASE("the instruction set has no effect where nothing is done in lanes") {
  const auto vain = [](const Words& words) {
    Words all{"--simd=scalar"};
    all.insert(all.end(), words.begin(), words.end());
    return fmt::format("{}", fmt::join(parse(all).without_effect, "\n"));
  };
  for (const char* engine : {"--accel=brute-force", "--bvh-width=2", "--count"}) {
    const Words words{"--accel=bvh", engine, "--integrator=normals", "-s"};
    const auto with = [&](const Words& more) {
      Words all = words;
      all.insert(all.end(), more.begin(), more.end());
      return all;
    };
    CHECK(vain(with({"1"})) ==
          "--simd: no effect, for neither the engine nor one sample a pixel of --integrator=normals has code "
          "for it");
    CHECK(vain(with({"2"})) == "");
    CHECK(vain(with({"1", "--integrator=path"})) == "");
    CHECK(vain(with({"1", "--integrator=direct"})) == "");
    CHECK(vain({"--accel=bvh", engine, "--replay", "1", "2", "0"})
              .find("--simd: no effect, for neither --replay nor the engine has code for it") !=
          std::string::npos);
  }
}

}  // namespace twinray::test

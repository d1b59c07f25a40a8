// SPDX-License-Identifier: Apache-2.0
#include "cli/cs184/options.h"

#include <fmt/format.h>

#include "cli/cs184/screenshot_name.h"
#include "core/error.h"
#include "tests/support/catch.h"

namespace twinray::test {
namespace {

RenderArguments parse_cs184(Words words) {
  words.push_back("scene.dae");
  return parse_cs184_arguments(words);
}

std::string cs184_message_of(Words words) {
  try {
    parse_cs184(std::move(words));
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("CS184's defaults hold where its program runs") {
  const RenderArguments arguments = parse_cs184({});
  CHECK(arguments.scene == "scene.dae");
  CHECK(arguments.render.samples == 1);
  CHECK(arguments.render.filter == usual_filter(FilterKind::box));
  CHECK(arguments.path.samples_per_light == 1);
  CHECK(arguments.render.threads == 1);
  CHECK(arguments.path.max_depth == 1);
  CHECK(arguments.path.first_depth == 0);
  CHECK(arguments.path.direct == DirectMethod::lights);
  CHECK(arguments.path.roulette.continuation == 0.7f);
  CHECK(arguments.path.many_lights == ManyLights::all);
  REQUIRE(arguments.render.adaptive);
  CHECK(arguments.render.adaptive->batch == 32);
  CHECK(arguments.render.adaptive->tolerance == 0.05);
  CHECK(arguments.render.adaptive->rule == AdaptiveRule::cs184);
  CHECK(arguments.render.width == 800);
  CHECK(arguments.render.height == 600);
  CHECK_FALSE(arguments.render.window);
  CHECK(arguments.output.empty());
  CHECK(arguments.camera_file.empty());
  CHECK(arguments.environment.empty());
  REQUIRE(arguments.changes.lens);
  CHECK(arguments.changes.lens->radius == 0);
  CHECK(arguments.changes.lens->focal_distance == 4.7f);
  CHECK(arguments.load.interpretation == Interpretation::cs184);
  CHECK(arguments.render.counting);
  CHECK(engine_name(arguments) == "bvh-2");
}

TEST_CASE("each letter of CS184's program has its meaning there") {
  const RenderArguments arguments =
      parse_cs184({"-s", "64", "-l",  "4",  "-t",  "2",   "-m", "7",       "-H", "-o",      "1",
                   "-a", "16", "0.1", "-r", "320", "240", "-e", "sky.exr", "-c", "cam.txt", "-p",
                   "10", "20", "30",  "40", "-b",  "0.5", "-d", "2.5",     "-f", "out.png"});
  CHECK(arguments.render.samples == 64);
  CHECK(arguments.path.samples_per_light == 4);
  CHECK(arguments.render.threads == 2);
  CHECK(arguments.path.max_depth == 7);
  CHECK(arguments.path.direct == DirectMethod::hemisphere);
  CHECK(arguments.render.adaptive->batch == 16);
  CHECK(arguments.render.adaptive->tolerance == 0.1);
  CHECK(arguments.render.width == 320);
  CHECK(arguments.render.height == 240);
  CHECK(arguments.environment == "sky.exr");
  CHECK(arguments.camera_file == "cam.txt");
  CHECK(arguments.render.window == PixelRect{10, 180, 40, 220});  // 20 to 60 pixels from the bottom
  CHECK(arguments.changes.lens->radius == 0.5f);
  CHECK(arguments.changes.lens->focal_distance == 2.5f);
  CHECK(arguments.output == "out.png");
}

TEST_CASE("option -o 0 shows the light of the last bounce that -m allows, and -o 1 all of it") {
  for (const int depth : {0, 1, 5}) {
    const RenderArguments last = parse_cs184({"-m", fmt::format("{}", depth), "-o", "0"});
    CHECK(last.path.max_depth == depth);
    CHECK(last.path.first_depth == depth);
    CHECK(last.path.last_depth == depth);
  }
  CHECK(parse_cs184({"-m", "5", "-o", "1"}).path.first_depth == 0);
  CHECK(cs184_message_of({"-o", "2"}) == "-o: there is no \"2\"; valid are 0, 1");
}

TEST_CASE("words stand as getopt takes them: behind the scene, and joined to their letter") {
  const RenderArguments behind =
      parse_cs184_arguments({"-s16", "a.dae", "-l", "8", "-r", "48", "36", "-H", "-f", "x"});
  CHECK(behind.scene == "a.dae");
  CHECK(behind.render.samples == 16);
  CHECK(behind.path.samples_per_light == 8);
  CHECK(behind.render.width == 48);
  CHECK(behind.output == "x");
  CHECK(parse_cs184({"-s", "4", "-s", "8"}).render.samples == 8);
  CHECK(parse_cs184_arguments({"-m2", "-H", "--", "a.dae"}).scene == "a.dae");
  CHECK(parse_cs184({"-r", "016", "012", "-a", "64", ".05"}).render.adaptive->tolerance == 0.05);
}

TEST_CASE("option -H takes no value, also as the last word") {
  CHECK(parse_cs184({"-H", "-m", "6"}).path.max_depth == 6);
  CHECK(parse_cs184_arguments({"-H", "a.dae"}).scene == "a.dae");
  CHECK(parse_cs184_arguments({"a.dae", "-H"}).path.direct == DirectMethod::hemisphere);
}

TEST_CASE("what CS184's program swallowed is refused in the option's name") {
  CHECK(cs184_message_of({"-r", "64", "-f", "x.png"}) == "-r: 2 numbers are needed, not 1");
  CHECK(cs184_message_of({"-r", "0", "0"}) == "-r: \"0\" is not a whole number from 1 to 65536");
  CHECK(cs184_message_of({"-t", "0"}) == "-t: \"0\" is not a whole number from 1 to 1024");
  CHECK(cs184_message_of({"-s", "many"}) == "-s: \"many\" is not a whole number from 1 to 4194304");
  CHECK(cs184_message_of({"-s", ""}) == "-s: its value is empty");
  CHECK(cs184_message_of({"-s", "-4"}) == "-s: \"-4\" is not a whole number from 1 to 4194304");
  CHECK(cs184_message_of({"-l", "0"}) == "-l: \"0\" is not a whole number from 1 to 65536");
  CHECK(cs184_message_of({"-m", "-1"}) == "-m: \"-1\" is not a whole number from 0 to 2147483647");
  CHECK(cs184_message_of({"-a", "0", "0.05"}) == "-a: \"0\" is not a whole number from 1 to 4194304");
  CHECK(cs184_message_of({"-a", "32", "nan"}) == "-a: \"nan\" is not a number from 0 to 1000000");
  CHECK(cs184_message_of({"-b", "-1"}) == "-b: \"-1\" is not a number from 0 to 1000000000");
  CHECK(cs184_message_of({"-b", "0.1", "-d", "0"}) ==
        "-d: behind a lens (-b) something is in focus at a distance greater than 0 only");
  CHECK(cs184_message_of({"-d", "0"}) == "accepted");
  CHECK(cs184_message_of({"-f", ""}) == "-f: its value is empty");
  CHECK(cs184_message_of({"-z"}) == "there is no option -z");
  CHECK(cs184_message_of({"-f", "-H"}) == "-f: its value is missing; -H is an option");
  CHECK_THROWS_WITH(parse_cs184_arguments({""}), "SCENE: its value is empty");
  CHECK(cs184_message_of({"b.dae"}) == "\"scene.dae\" is one word too many");
}

TEST_CASE("a cell must lie within the frame, whose lowest row is 0") {
  CHECK(parse_cs184({"-r", "64", "48", "-p", "0", "0", "8", "4"}).render.window == PixelRect{0, 44, 8, 48});
  CHECK(parse_cs184({"-r", "64", "48", "-p", "0", "0", "64", "48"}).render.window == PixelRect{0, 0, 64, 48});
  CHECK(cs184_message_of({"-r", "64", "48", "-p", "60", "0", "8", "4"}) ==
        "-p: 60 0 8 4 (X Y DX DY) is not a part of 64 x 48 pixels");
  CHECK(cs184_message_of({"-r", "64", "48", "-p", "0", "45", "8", "4"}) ==
        "-p: 0 45 8 4 (X Y DX DY) is not a part of 64 x 48 pixels");
  CHECK(cs184_message_of({"-p", "0", "0", "0", "4"}) ==
        "-p: 0 0 0 4 (X Y DX DY) is not a part of 800 x 600 pixels");
}

TEST_CASE("paths of any depth are asked for, and end after 100 bounces with a warning") {
  CHECK(parse_cs184({"-m", "100"}).without_effect.empty());
  const RenderArguments deep = parse_cs184({"-m", "1000"});
  CHECK(deep.path.max_depth == 100);
  CHECK(deep.without_effect == Words{"-m: paths end after 100 bounces, not after 1000"});
}

TEST_CASE("options without a letter mean what they mean elsewhere") {
  CHECK(parse_cs184({"--integrator=normals"}).integrator == IntegratorKind::normals);
  CHECK(parse_cs184({"--integrator=normals"}).load.surfaces_only);
  CHECK_FALSE(parse_cs184({}).load.surfaces_only);
  CHECK(parse_cs184({"--accel=brute-force"}).backend == Backend::brute_force);
  CHECK(parse_cs184({"--roulette=0.5"}).path.roulette.continuation == 0.5f);
  CHECK(parse_cs184({"--bounces=indirect", "-m", "5"}).path.first_depth == 2);
  CHECK(parse_cs184({"--adaptive-rule=careful"}).render.adaptive->rule == AdaptiveRule::careful);
  CHECK(parse_cs184({"--seed=3"}).render.seed == 3);
  CHECK(parse_cs184({"--bvh-split=median"}).without_effect.empty());
  CHECK(parse_cs184({"--default-light"}).default_light == DefaultLight::if_dark);
  CHECK(cs184_message_of({"--view=whole"}) == "there is no option --view=whole");
  CHECK(cs184_message_of({"--clip=file"}) == "there is no option --clip=file; did you mean --clamp?");
  CHECK(parse_cs184({"--attenuation=file"}).without_effect ==
        Words{"--attenuation: no effect, for point lights do not fall off in CS184's program"});
  CHECK(parse_cs184({"--accel=brute-force", "--bvh-split=median"}).without_effect ==
        Words{"--bvh-split: no effect, for the engine is brute-force; --accel=bvh takes it"});
}

TEST_CASE("options without a letter are checked as they are elsewhere") {
  CHECK(parse_cs184({"--tev=127.0.0.1:14158"}).viewer.has_value());
  CHECK(cs184_message_of({"--tev=foo:99999"}).starts_with("--tev: "));
  CHECK(cs184_message_of({"-H", "--direct=lights"}) ==
        "-H is --direct=hemisphere, and --direct says another thing");
  CHECK(cs184_message_of({"-H", "--direct=hemisphere"}) == "accepted");
  CHECK(cs184_message_of({"-o", "0", "--bounces=all"}) ==
        "-o 0 is --bounces=last, and --bounces says it, too, or another thing");
}

TEST_CASE("a screenshot has the scene's name and the time in short numbers") {
  std::tm time{};
  time.tm_mon = 3;
  time.tm_mday = 9;
  time.tm_hour = 16;
  time.tm_min = 5;
  CHECK(screenshot_name("dae/sky/CBbunny.dae", time) == "CBbunny_screenshot_4-9_16-5-0.png");
  CHECK(screenshot_name("cow", time) == "cow_screenshot_4-9_16-5-0.png");
}

}  // namespace twinray::test

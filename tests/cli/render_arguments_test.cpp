// SPDX-License-Identifier: Apache-2.0
#include "cli/options/render.h"
#include "cli/render_command_line.h"

#include <fmt/format.h>

#include "accel/fastest_engine.h"
#include "cli/picture_metadata.h"
#include "core/error.h"
#include "tests/support/arguments.h"
#include "tests/support/catch.h"

namespace twinray::test {

TEST_CASE("CS184's options take the same arguments") {
  const RenderArguments arguments = parse({"-s",       "64", "-l",  "4",  "-t",  "2",   "-m", "7",       "-H",
                                           "-a",       "16", "0.1", "-r", "320", "240", "-e", "sky.exr", "-c",
                                           "cam.info", "-p", "10",  "20", "30",  "40",  "-f", "out.png"});
  CHECK(arguments.scene == "scene.dae");
  CHECK(arguments.render.samples == 64);
  CHECK(arguments.path.samples_per_light == 4);
  CHECK(arguments.render.threads == 2);
  CHECK(arguments.path.max_depth == 7);
  CHECK(arguments.path.direct == DirectMethod::hemisphere);
  REQUIRE(arguments.render.adaptive);
  CHECK(arguments.render.adaptive->batch == 16);
  CHECK(arguments.render.adaptive->tolerance == 0.1);
  CHECK(arguments.render.adaptive->rule == AdaptiveRule::careful);
  CHECK(arguments.render.width == 320);
  CHECK(arguments.render.height == 240);
  CHECK(arguments.environment == "sky.exr");
  CHECK(arguments.camera_file == "cam.info");
  CHECK(arguments.render.window == PixelRect{10, 20, 40, 60});
  CHECK(arguments.output == "out.png");
}

TEST_CASE("Embree's builders go with the bvh engine, and exclude the options of our own") {
  CHECK(parse({"--accel=bvh"}).build.bvh_builder == BvhBuilder::own);
#ifdef TWINRAY_WITH_EMBREE
  CHECK(parse({"--accel=bvh", "--bvh-builder=embree-low", "--bvh-width=2", "--max-leaf-size=8"})
            .build.bvh_builder == BvhBuilder::embree_low);
  CHECK(no_effect({"--accel=embree", "--bvh-builder=embree-low"}) ==
        "--bvh-builder: no effect, for the engine is embree; --accel=bvh takes it");
  CHECK(no_effect({"--accel=bvh", "--bvh-builder=embree-medium", "--bvh-split=mean"}) ==
        "--bvh-split: no effect, for the builder is embree-medium");
  CHECK(no_effect({"--accel=bvh", "--bvh-builder=embree-medium", "--bvh-bins=8"}) ==
        "--bvh-bins: no effect, for the builder is embree-medium");
  CHECK(message_of({"--accel=bvh", "--bvh-builder=embree-low", "--max-leaf-size=33"}) ==
        "--max-leaf-size: Embree's builders make leaves of up to 32 primitives");
  CHECK(message_of({"--bvh-builder=embree"}) ==
        "--bvh-builder: there is no \"embree\"; valid are own, embree-low, embree-medium, embree-high");
#else
  CHECK(message_of({"--bvh-builder=embree-low"}) ==
        "--bvh-builder: there is no \"embree-low\"; valid are own");
#endif
}

TEST_CASE("the bvh is eight wide, but two wide for counts, unless a width is named") {
  CHECK(parse({"--accel=bvh"}).build.bvh_width == 8);
  CHECK(parse({"--accel=bvh", "--count"}).build.bvh_width == 2);
  CHECK(parse({"--accel=bvh", "--integrator=cost"}).build.bvh_width == 2);
  CHECK(parse({"--accel=bvh", "--count", "--bvh-width=8"}).build.bvh_width == 8);
  CHECK(parse({"--accel=bvh", "--bvh-width=2"}).build.bvh_width == 2);
  CHECK(parse({"--accel=bvh", "--bvh-width=2", "--max-leaf-size=5"}).build.max_leaf_size == 5);
  CHECK(message_of({"--accel=bvh", "--max-leaf-size=5"}) ==
        "--max-leaf-size: a BVH of width 8 has leaves of up to 4; --bvh-width=2 takes more");
}

TEST_CASE("check renders by the bvh and names the engine that it is checked with") {
  CHECK_FALSE(parse({}).check_with);
  const RenderArguments usual = parse({"--accel=check", "--bvh-split=mean"});
  CHECK(usual.backend == Backend::bvh);
  REQUIRE(usual.check_with);
  CHECK(usual.check_with->build.bvh_split == BvhSplit::mean);
#ifdef TWINRAY_WITH_EMBREE
  CHECK(usual.check_with->name == "embree");
  CHECK(parse({"--accel=check", "--check-with=embree-native"}).check_with->backend == Backend::embree_native);
#else
  CHECK(usual.check_with->name == "bvh-2");
#endif
  CHECK(parse({"--accel=check", "--check-with=bvh-2"}).check_with->build.bvh_width == 2);
  CHECK(parse({"--accel=check", "--plant-difference"}).check_with->build.triangle_test ==
        TriangleTest::moller_trumbore);
  CHECK(no_effect({"--check-with=bvh-2"}) ==
        "--check-with: no effect, for nothing is checked; --accel=check takes it");
  CHECK(no_effect({"--accel=bvh", "--plant-difference"}) ==
        "--plant-difference: no effect, for nothing is checked; --accel=check takes it");
  CHECK(message_of({"--accel=check", "--check-with=bvh-2", "--plant-difference"}) ==
        "--plant-difference is an engine of its own; it does not go with --check-with");
  CHECK(message_of({"--accel=check", "--check-with=bvh-2", "--bvh-width=2"}) ==
        "--check-with=bvh-2: that is the engine which is checked; render with --bvh-width=8");
  CHECK(message_of({"--accel=check", "--triangle-test=moller-trumbore"}) ==
        "--triangle-test=moller-trumbore does not go with --accel=check");
  CHECK(message_of({"--accel=check", "--check-with=bvh"}).find("there is no \"bvh\"; valid are ") !=
        std::string::npos);
}

TEST_CASE("a quality goes with the wide bvh alone") {
  CHECK(parse({"--accel=bvh"}).build.bvh_quality == BvhQuality::medium);
  CHECK(parse({"--accel=bvh", "--bvh-quality=high"}).build.bvh_quality == BvhQuality::high);
  for (const auto& words : {std::vector<std::string>{"--accel=bvh", "--bvh-width=2", "--bvh-quality=fast"},
                            {"--accel=bvh", "--count", "--bvh-quality=fast"}})
    CHECK(no_effect(words) == "--bvh-quality: no effect, for the bvh is binary; --bvh-width=8 takes it");
  CHECK(no_effect({"--accel=brute-force", "--bvh-quality=high"}) ==
        "--bvh-quality: no effect, for the engine is brute-force; --accel=bvh takes it");
}

TEST_CASE("cost shows what the engine counts: nodes of the bvh, else primitives") {
  const RenderArguments nodes = parse({"--integrator=cost", "--accel=bvh"});
  CHECK(nodes.cost == CostKind::nodes);
  CHECK(nodes.render.counting);
  CHECK(parse({"--integrator=cost", "--accel=bvh", "--cost=primitives"}).cost == CostKind::primitives);
  CHECK(parse({"--integrator=cost", "--accel=brute-force"}).cost == CostKind::primitives);
  CHECK(message_of({"--integrator=cost", "--accel=brute-force", "--cost=nodes"}) ==
        "--cost=nodes: brute-force has no nodes that could be counted; valid are --cost=primitives, or "
        "--accel=bvh");
  CHECK(no_effect({"--clip=file", "--view=whole"}) ==
        "--clip: no effect, for --view=whole leaves no clip distances");
  CHECK(no_effect({"--integrator=normals", "--attenuation=file"}) ==
        "--attenuation: no effect, for --integrator=normals does not ask for the scene's light");
  CHECK(no_effect({"--integrator=normals", "--default-light"}) ==
        "--default-light: no effect, for --integrator=normals does not ask for the scene's light");
  CHECK(no_effect({"--cost=nodes"}) == "--cost: no effect, for --integrator=cost alone shows costs");
#ifdef TWINRAY_WITH_EMBREE
  CHECK(parse({"--integrator=cost", "--accel=embree"}).cost == CostKind::primitives);
  CHECK(message_of({"--integrator=cost", "--accel=embree", "--cost=nodes"}) ==
        "--cost=nodes: embree has no nodes that could be counted; valid are --cost=primitives, or "
        "--accel=bvh");
  CHECK(message_of({"--integrator=cost", "--accel=embree-native"}) ==
        "--integrator=cost: embree-native counts nothing");
#endif
}

TEST_CASE("options may follow the scene, and long names mean the same") {
  const auto arguments =
      parse_render_arguments({"scene.dae", "--samples=8", "--light-samples=2", "--max-depth=0",
                              "--resolution", "10", "12", "--output=x.exr"});
  CHECK(arguments.render.samples == 8);
  CHECK(arguments.path.samples_per_light == 2);
  CHECK(arguments.path.max_depth == 0);
  CHECK(arguments.render.height == 12);
  CHECK(arguments.output == "x.exr");
}

TEST_CASE(
    "without options a picture of 480 x 360 with 32 samples and depth 5 is made, without adaptive sampling") {
  const RenderArguments arguments = parse({});
  CHECK(arguments.render.width == 480);
  CHECK(arguments.render.height == 360);
  CHECK(arguments.render.samples == 32);
  CHECK(arguments.path.max_depth == 5);
  CHECK_FALSE(arguments.render.adaptive);
  CHECK(arguments.is_auto);
}

TEST_CASE("the bounces that are shown are ranges of depth") {
  CHECK(parse({"--bounces=direct"}).path.last_depth == 1);
  CHECK(parse({"--bounces=indirect"}).path.first_depth == 2);
  const RenderArguments last = parse({"--bounces=last", "-m", "3"});
  CHECK(last.path.first_depth == 3);
  CHECK(last.path.last_depth == 3);
  CHECK(parse({"--integrator=direct"}).path.max_depth == 1);
}

TEST_CASE("the clamp is off or a radiance, and changes indirect light alone") {
  CHECK(std::isinf(parse({}).path.clamp));
  CHECK(std::isinf(parse({"--clamp=off"}).path.clamp));
  CHECK(parse({"--clamp=2.5"}).path.clamp == 2.5f);
  for (const std::string word : {"0", "-1", "inf", "nan", "2x", "on", "2e9"})
    CHECK(message_of({"--clamp=" + word}) ==
          "--clamp: \"" + word + "\"; valid are off and a radiance in (0, 10^9]");
  for (const std::string option : {"--clamp", "--regularize"}) {
    const std::string word = option == "--clamp" ? "--clamp=2" : option;
    const std::string too_short = option + ": no effect, for light of one bounce is left as it is";
    CHECK(no_effect({word, "-m", "1"}) == too_short);
    CHECK(no_effect({word, "--bounces=direct"}) == too_short);
    CHECK(no_effect({word, "-m", "2"}).empty());
    CHECK(no_effect({word, "--integrator=normals"}) ==
          option + ": no effect, for --integrator=normals does not ask for the scene's light");
  }
}

TEST_CASE("a picture names what keeps it from converging to the scene's light") {
  const auto biased_by = [](const std::vector<std::string>& words) {
    for (const auto& [key, value] : picture_metadata(parse(words), words))
      if (key == "twinray:biased_by") return value;
    return std::string("nothing");
  };
  CHECK(biased_by({}) == "nothing");
  CHECK(biased_by({"--clamp=2.5"}) == "clamp 2.5");
  CHECK(biased_by({"--regularize", "--clamp=4"}) == "clamp 4, regularize");
}

TEST_CASE("roulette takes a probability or the word throughput") {
  CHECK(parse({"--roulette=0.7"}).path.roulette.continuation == 0.7f);
  CHECK(parse({"--roulette=1"}).path.roulette.continuation == 1);
  CHECK(parse({"--roulette=throughput"}).path.roulette.continuation == 0);
  CHECK(message_of({"--roulette=2"}) ==
        "--roulette: \"2\"; valid are throughput and a probability in (0, 1]");
}

TEST_CASE("the scene may stand between the options, and the last of equal ones counts") {
  const RenderArguments arguments =
      parse_render_arguments({"-r", "8", "6", "scene.dae", "-r", "16", "12", "-s", "1", "-s", "3"});
  CHECK(arguments.scene == "scene.dae");
  CHECK(arguments.render.width == 16);
  CHECK(arguments.render.height == 12);
  CHECK(arguments.render.samples == 3);
}

TEST_CASE("a wrong word of a choice names the right ones") {
  CHECK(message_of({"--bvh-split=sahh"}) ==
        "--bvh-split: there is no \"sahh\"; valid are sah, median, midpoint, mean");
  CHECK(message_of({"--bvh-quality=best"}) ==
        "--bvh-quality: there is no \"best\"; valid are fast, medium, high");
  CHECK(message_of({"--bvh-width=4"}) == "--bvh-width: there is no \"4\"; valid are 2, 8");
  CHECK(message_of({"--integrator=photon"}) ==
        "--integrator: there is no \"photon\"; valid are path, path-reference, direct, "
        "ambient-occlusion, furnace, normals, cost");
}

TEST_CASE("an option without effect is named with the reason, and refused by a strict run") {
  const std::string embree = ": no effect, for the engine is brute-force; --accel=bvh takes it";
  for (const char* option : {"--bvh-split=mean", "--bvh-width=2", "--bvh-bins=8", "--bvh-quality=fast",
                             "--max-leaf-size=3", "--traversal-cost=2", "--intersection-cost=2"}) {
    const std::string text = option;
    CHECK(no_effect({"--accel=brute-force", option}) == text.substr(0, text.find('=')) + embree);
    CHECK(no_effect({"--accel=bvh", "--bvh-width=8", option}).empty());
  }
  CHECK(no_effect({"--accel=bvh", "--bvh-split=mean", "--bvh-bins=8"}) ==
        "--bvh-bins: no effect, for --bvh-split=sah alone has bins");
  CHECK(no_effect({"-a", "32", "0.05", "-s", "32"}) ==
        "--adaptive: no effect, for a batch of 32 is all of the 32 samples");
  CHECK(no_effect({"-a", "32", "0.05", "-s", "33"}).empty());
  CHECK(no_effect({"--allocation=error", "-s", "16"}) ==
        "--allocation: no effect, for the first 16 samples are even, and 16 are asked for");
  CHECK(no_effect({"--allocation=error", "-s", "17"}).empty());
  for (const char* integrator : {"--integrator=path", "--integrator=path-reference"})
    CHECK(
        no_effect({integrator, "-l", "4", "-m", "3", "-H", "--roulette=0.5", "--attenuation=file"}).empty());
#ifdef TWINRAY_WITH_EMBREE
  CHECK(no_effect({"--accel=bvh", "--embree-mode=fast"}) ==
        "--embree-mode: no effect, for --accel=embree-native alone has modes");
  CHECK(no_effect({"--accel=bvh", "--embree-isa=avx"}) == "--embree-isa: no effect, for the engine is bvh");
  CHECK(no_effect({"--accel=embree", "--embree-isa=avx"}).empty());
  CHECK(no_effect({"--accel=check", "--embree-isa=avx"}).empty());
  CHECK(no_effect({"--accel=embree-native", "--count"}) ==
        "--count: no effect, for embree-native does not count");
#endif
}

TEST_CASE("auto lets the scene choose the engine, and takes no options of one") {
  const Geometry none;
  RenderArguments arguments = parse({"--accel=auto", "--simd=scalar", "-t", "3"});
  CHECK(arguments.is_auto);
  CHECK(arguments.without_effect.empty());
  choose_engine(none, arguments);
  const EngineChoice choice = fastest_engine(none, {.threads = 3, .simd = "scalar"});
  CHECK(engine_name(arguments) == choice.engine.name);
  CHECK(arguments.build.threads == 3);
  CHECK(arguments.build.simd == "scalar");
  CHECK(arguments.engine_reason == choice.reason);
  RenderArguments named = parse({"--accel=brute-force"});
  choose_engine(none, named);
  CHECK(engine_name(named) == "brute-force");
  CHECK(named.engine_reason == "named by --accel");
  const std::string reason =
      ": no effect, for --accel=auto chooses the engine and its options; --accel=bvh takes it";
  CHECK(no_effect({"--bvh-split=mean"}) == "--bvh-split" + reason);
  CHECK(no_effect({"--max-leaf-size=9"}) == "--max-leaf-size" + reason);
}

TEST_CASE("to count, auto is the binary tree, whose counts compare") {
  for (const char* option : {"--count", "--integrator=cost"}) {
    const RenderArguments arguments = parse({option});
    CHECK_FALSE(arguments.is_auto);
    CHECK(engine_name(arguments) == "bvh-2");
    CHECK(arguments.engine_reason == "its counts compare among all trees");
  }
  CHECK(parse({"--integrator=cost"}).cost == CostKind::nodes);
}

TEST_CASE("an option of light has no effect where light of its kind is not computed") {
  for (const char* option :
       {"--direct=hemisphere", "-H", "-l4", "--bounces=last", "--roulette=0.5", "-esky.exr"})
    CHECK(no_effect({"--integrator=normals", option})
              .find(": no effect, for --integrator=normals does not ask for the scene's light") !=
          std::string::npos);
  CHECK(no_effect({"-m", "0", "-l", "4"}) ==
        "--light-samples: no effect, for --max-depth=0 leaves the light of emitters alone");
  CHECK(no_effect({"-m", "1", "-l", "4"}).empty());
  CHECK(no_effect({"--integrator=direct", "-m", "2"}) ==
        "--max-depth: no effect, for --integrator=direct ends paths after one bounce");
  CHECK(no_effect({"--integrator=direct", "-m", "1"}).empty());
  CHECK(no_effect({"--integrator=direct", "--bounces=direct"}) ==
        "--bounces: no effect, for no other light than direct light is computed");
  CHECK(no_effect({"--roulette=0.5", "-m", "2"}) ==
        "--roulette: no effect, for paths of 2 bounces end before it decides");
  CHECK(no_effect({"--roulette=0.5", "-m", "3"}).empty());
}

TEST_CASE("indirect light of paths that have none is a contradiction, not a black picture") {
  CHECK(message_of({"--integrator=direct", "--bounces=indirect"}) ==
        "--bounces=indirect: indirect light takes two bounces, and only one is made");
  CHECK(message_of({"-m", "0", "--bounces=indirect"}) ==
        "--bounces=indirect: indirect light takes two bounces, and none is made");
  CHECK(message_of({"-m", "2", "--bounces=indirect"}) == "accepted");
}

TEST_CASE("time decides how many samples there are, and a number of samples is the most") {
  CHECK_FALSE(parse({}).render.seconds);
  CHECK(parse({"--seconds=2.5"}).render.seconds == 2.5);
  CHECK(parse({"--seconds=2.5"}).render.samples == Film::max_samples);
  CHECK(parse({"--seconds=2.5", "-s", "7"}).render.samples == 7);
}

TEST_CASE("a number out of range, or no number, is refused in the option's name with what is valid") {
  CHECK(message_of({"-r", "0", "10"}) == "--resolution: \"0\" is not a whole number from 1 to 65536");
  CHECK(message_of({"-r", "10", "48x"}) == "--resolution: \"48x\" is not a whole number from 1 to 65536");
  CHECK(message_of({"-r", "64"}) == "--resolution: 2 numbers are needed, not 1");
  CHECK(message_of({"--allocation=error", "-a", "32", "0.05"}) ==
        "--allocation=error spreads as many samples, --adaptive takes fewer: give one of them");
  CHECK(message_of({"--adaptive-rule=cs184"}) == "--adaptive-rule goes with --adaptive");
  CHECK(message_of({"--seconds=0"}) == "--seconds: \"0\" is not a number from 0.001 to 1000000000");
  CHECK(message_of({"-a", "1", "0.05"}) == "--adaptive: \"1\" is not a whole number from 2 to 4194304");
  CHECK(message_of({"-a", "32.5", "0.05"}) == "--adaptive: \"32.5\" is not a whole number from 2 to 4194304");
  CHECK(message_of({"-a", "32", "-1"}) == "--adaptive: \"-1\" is not a number from 0 to 1000000");
  CHECK(message_of({"-a", "32", "nan"}) == "--adaptive: \"nan\" is not a number from 0 to 1000000");
  CHECK(message_of({"-s", "0"}) == "--samples: \"0\" is not a whole number from 1 to 4194304");
  CHECK(message_of({"-s", "many"}) == "--samples: \"many\" is not a whole number from 1 to 4194304");
  CHECK(message_of({"-m", "101"}) == "--max-depth: \"101\" is not a whole number from 0 to 100");
  CHECK(message_of({"-t", "0"}) == "--threads: \"0\" is not a whole number from 1 to 1024");
  CHECK(message_of({"--traversal-cost=1e7"}) ==
        "--traversal-cost: \"1e7\" is not a number from 1e-06 to 1000000");
}

TEST_CASE("a seed is a whole number of 64 bits, and no other number passes for one") {
  CHECK(parse({"--seed=18446744073709551615"}).render.seed == 18446744073709551615u);
  for (const char* seed : {"-1", "18446744073709551616", "1.5", "0x10"})
    CHECK(message_of({"--seed", seed}) ==
          fmt::format("--seed: \"{}\" is not a whole number from 0 to 18446744073709551615", seed));
}

TEST_CASE("an empty value is no value") {
  CHECK(message_of({"--seed", ""}) == "--seed: its value is empty");
  CHECK(message_of({"-o", ""}) == "--output: its value is empty");
  CHECK(message_of({"-r", "8", ""}) == "--resolution: its value is empty");
}

TEST_CASE("a crop is a corner and a size, and may be all of the frame") {
  CHECK(parse({"-p", "2", "3", "40", "50"}).render.window == PixelRect{2, 3, 42, 53});
  CHECK(parse({"-p", "0", "0", "480", "360"}).render.window == PixelRect{0, 0, 480, 360});
  CHECK(parse({"-p", "479", "359", "1", "1"}).render.window == PixelRect{479, 359, 480, 360});
  CHECK(message_of({"-p", "479", "359", "1", "2"}) != "accepted");
  CHECK(message_of({"-p", "0", "0", "480", "0"}) != "accepted");
}

TEST_CASE("a crop that is no part of the frame is refused, however large its numbers are") {
  CHECK(message_of({"-p", "0", "0", "481", "10"}) ==
        "--crop: 0 0 481 10 (X Y W H) is not a part of 480 x 360 pixels");
  CHECK(message_of({"-p", "2147483647", "0", "2147483647", "1"}) ==
        "--crop: 2147483647 0 2147483647 1 (X Y W H) is not a part of 480 x 360 pixels");
  CHECK(message_of({"-p", "-2147483648", "0", "1", "1"}) ==
        "--crop: -2147483648 0 1 1 (X Y W H) is not a part of 480 x 360 pixels");
}

TEST_CASE("words that are missing, unknown or too many are named") {
  CHECK(message_of({"--no-such-option"}) == "there is no option --no-such-option");
  CHECK(message_of({"other.dae"}) == "\"scene.dae\" is one word too many");
  CHECK(message_of({"--quiet=5"}) == "--quiet takes no value");
  CHECK(message_of({"--stats="}) == "--stats: its value is missing");
  try {
    parse_render_arguments({"-o", "a.png"});
    FAIL("accepted");
  } catch (const UsageError& error) {
    CHECK(std::string(error.what()) == "SCENE is missing");
  }
  try {
    parse_render_arguments({"scene.dae", "--stats"});
    FAIL("accepted");
  } catch (const UsageError& error) {
    CHECK(std::string(error.what()) == "--stats: FILE is missing");
  }
}

TEST_CASE("what a scene file says about its picture holds where no option says something else") {
  const RenderDefaults defaults{RenderDefaults::Resolution{200, 100}, std::array{0, 0, 100, 50}, 7, 9, {}};
  const auto with = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "scene.pbrt");
    RenderArguments arguments = parse_render_arguments(words);
    take_defaults(defaults, arguments);
    return arguments;
  };
  const RenderArguments plain = with({});
  CHECK(plain.render.width == 200);
  CHECK(plain.render.height == 100);
  CHECK(plain.render.window == PixelRect{0, 0, 100, 50});
  CHECK(plain.render.samples == 7);
  CHECK(plain.path.max_depth == 9);
  const RenderArguments given = with({"-r", "40", "30", "-s", "3", "-m", "2"});
  CHECK(given.render.width == 40);
  CHECK(given.render.window == PixelRect{0, 0, 20, 15});  // The same part of it.
  CHECK(with({"-r", "200", "100"}).render.window == PixelRect{0, 0, 100, 50});
  CHECK(with({"-r", "1", "1"}).render.window == PixelRect{0, 0, 1, 1});
  CHECK(with({"--overscan=2", "-o", "a.exr"}).render.window == PixelRect{-2, -2, 202, 102});
  CHECK(given.render.samples == 3);
  CHECK(given.path.max_depth == 2);
  CHECK(with({"-p", "150", "50", "50", "50"}).render.window == PixelRect{150, 50, 200, 100});
  CHECK_THROWS_WITH(with({"-p", "150", "50", "51", "50"}),
                    "--crop: 150 50 51 50 (X Y W H) is not a part of 200 x 100 pixels");
  CHECK(with({"--bounces=last"}).path.first_depth == 9);
  CHECK(with({"--integrator=direct"}).path.max_depth == 1);
  RenderArguments other = parse_render_arguments({"scene.pbrt"});
  take_defaults({}, other);
  CHECK(other.render.width == RenderOptions{}.width);
}

}  // namespace twinray::test

// SPDX-License-Identifier: Apache-2.0
// --layers=light-groups, --light-group and relight: which lights stand together, and how they are mixed anew.
#include "cli/light_groups.h"

#include <fmt/format.h>

#include "cli/relight/command.h"
#include "cli/relight/relight.h"
#include "core/error.h"
#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/layered_exr.h"
#include "tests/support/own_scenes.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

namespace twinray::test {
namespace {

/// Lights of these names, wherever they are.
Scene lights(const std::vector<std::string>& names) {
  Scene scene;
  for (const std::string& name : names) scene.lights.push_back({name, PointLight{}});
  return scene;
}

/// The group of each light.
std::vector<std::string> groups_of(std::vector<std::string> names, const std::vector<std::string>& rules) {
  Scene scene = lights(names);
  std::vector<LightGroupRule> parsed;
  for (const std::string& rule : rules) parsed.push_back(parse_light_group(rule));
  group_lights(scene, parsed);
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = scene.light_groups[scene.lights[i].group];
  return names;
}

/// A picture of two groups, one pixel of each: "key" is red, "fill" green and brighter.
std::string two_groups(const TemporaryFolder& folder) {
  const std::string path = folder.file("two.exr");
  write_text(path, layered_exr(2, 1,
                               {{"R", {1, 0.5f}},
                                {"G", {2, 4}},
                                {"B", {0, 0.25f}},
                                {"Z", {7, 8}},
                                {"diffuse_direct.R", {1, 0.5f}},
                                {"variance.Y", {3, 3}},
                                {"noisy.R", {1, 1}},
                                {"light_key.R", {1, 0.5f}},
                                {"light_key.G", {0, 0}},
                                {"light_key.B", {0, 0.25f}},
                                {"light_fill.R", {0, 0}},
                                {"light_fill.G", {2, 4}},
                                {"light_fill.B", {0, 0}}}));
  return path;
}

std::string message_in(const std::string& text) {
  try {
    parse_light_change(text);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("each light is a group of its own name, in letters that layers can have") {
  CHECK(groups_of({"Sun", "Lamp.001", "area light, line 4", "Sun", ""}, {}) ==
        std::vector<std::string>{"Sun", "Lamp_001", "area_light__line_4", "Sun", "light"});
}

TEST_CASE("lights whose names differ in other signs alone are groups of their own, numbered") {
  CHECK(groups_of({"lamp.1", "lamp_1", "lamp 1", "lamp_1", "lamp_1_2"}, {}) ==
        std::vector<std::string>{"lamp_1", "lamp_1_2", "lamp_1_3", "lamp_1_2", "lamp_1_2_2"});
}

TEST_CASE("what media emit is a light of its own, called media") {
  const auto grouped = [](const std::vector<std::string>& names, const std::vector<LightGroupRule>& rules) {
    Scene scene = lights(names);
    scene.materials.push_back({"ember", Interface{}, {}, {.absorption = {1, 1, 1}, .glow = {{1, 1, 1}}}});
    group_lights(scene, rules);
    return scene;
  };
  const Scene own = grouped({"key"}, {});
  CHECK(own.light_groups == std::vector<std::string>{"key", "media"});
  CHECK(own.media_group == 1);
  CHECK(grouped({}, {}).light_groups == std::vector<std::string>{"media"});
  const Scene all = grouped({"key"}, {parse_light_group("all=*")});
  CHECK(all.light_groups == std::vector<std::string>{"all"});
  CHECK(all.media_group == 0);
  CHECK(grouped({"key"}, {parse_light_group("fire=media")}).light_groups ==
        std::vector<std::string>{"key", "fire"});
  Scene dark = lights({"key"});
  group_lights(dark, {});
  CHECK(dark.media_group == no_light);
}

TEST_CASE("a group that has the name of a light beside it is refused") {
  CHECK(groups_of({"sun", "spot"}, {"sun=sun,spot"}) == std::vector<std::string>{"sun", "sun"});
  CHECK_THROWS_WITH(
      groups_of({"a lamp", "spot"}, {"a_lamp=spot"}),
      "--light-group: the light \"a lamp\" is no part of the group \"a_lamp\", and has its name; "
      "give the group another one");
}

TEST_CASE("a light belongs to the first group that names it, by its name or any text in it") {
  CHECK(groups_of({"lamp 1", "lamp 2", "sun", "sky"}, {"warm=lamp 1", "all=lamp*,*un"}) ==
        std::vector<std::string>{"warm", "all", "all", "sky"});
  CHECK(groups_of({"a-b-c", "abc"}, {"x=a*b*c"}) == std::vector<std::string>{"x", "x"});
  CHECK(groups_of({"abcd", "abc"}, {"x=a*c"}) == std::vector<std::string>{"abcd", "x"});
  CHECK(groups_of({"a", "aa", "aba", "ab"}, {"x=a*a"}) == std::vector<std::string>{"a", "x", "x", "ab"});
  CHECK(groups_of({"key 1 left", "key left 1"}, {"x=*1*left*"}) ==
        std::vector<std::string>{"x", "key_left_1"});
  CHECK(groups_of({"any"}, {"x=**"}) == std::vector<std::string>{"x"});
  // No way of trying all ways to split a name would come to an end.
  const std::string long_name(200, 'a');
  CHECK(
      groups_of({long_name + "c", long_name}, {"x=" + std::string(20, '*') + "a*a*a*a*a*a*a*a*c"}).front() ==
      "x");
}

TEST_CASE("a group without lights, and more groups than layers, are refused") {
  CHECK_THROWS_WITH(groups_of({"sun", "sky"}, {"x=lamp*"}),
                    "--light-group: no light is called \"lamp*\"; the scene has \"sun\", \"sky\"");
  CHECK_THROWS_WITH(groups_of({}, {"x=*"}), "--light-group: no light is called \"*\"; the scene has none");
  CHECK_THROWS_WITH(groups_of({"sun", "sky"}, {"all=*", "day=sun"}),
                    "--light-group: all lights of \"day\" belong to the groups before it");
  std::vector<std::string> many;
  for (std::size_t i = 0; i < most_light_groups; ++i) many.push_back(fmt::format("lamp{}", i));
  CHECK(groups_of(many, {}).size() == most_light_groups);
  many.push_back("one more");
  CHECK_THROWS_WITH(groups_of(many, {}),
                    "--layers=light-groups: the scene's 65 lights are more than 64 groups; "
                    "--light-group=NAME=LIGHT,... makes one of several, * stands for any text");
  CHECK(groups_of(many, {"all=*"}).back() == "all");
}

TEST_CASE("what is no group on the command line is refused with what is valid") {
  for (const char* const text : {"key", "=sun", "key=", "key light=sun", "k.y=sun"})
    CHECK_THROWS_WITH(parse_light_group(text),
                      fmt::format("--light-group: \"{}\" is no group; valid is NAME=LIGHT,... where the name "
                                  "has letters, digits, \"-\" and \"_\", and * in a light's name stands for "
                                  "any text",
                                  text));
}

TEST_CASE("a change of a light group is a number or a colour") {
  CHECK(parse_light_change("key=0.5").factor == Rgb{0.5f, 0.5f, 0.5f});
  CHECK(parse_light_change("key=1,0,2").factor == Rgb{1, 0, 2});
  CHECK(parse_light_change("key=1,0,2").group == "key");
  for (const char* const text : {"key", "key=", "=1", "key=1,2", "key=1,2,3,4"})
    CHECK(message_in(text) ==
          fmt::format("--light: \"{}\" is no change; valid are GROUP=X and GROUP=R,G,B", text));
  CHECK(message_in("key=-1") == "--light: \"-1\" is not a number from 0 to 1000000");
}

TEST_CASE("lights are mixed anew: the colours are the sum of the groups, each times its factor") {
  const TemporaryFolder folder;
  StoredLayers picture = read_layers(two_groups(folder));
  CHECK(light_groups_of(picture) == std::vector<std::string>{"fill", "key"});
  relight(picture, std::vector<LightChange>{{"key", {2, 1, 4}}, {"fill", {1, 0.5f, 1}}}, "two.exr");
  CHECK(colors_of(picture).pixels == std::vector<Rgb>{{2, 1, 0}, {1, 2, 1}});
  for (const PictureChannel& channel : picture.channels) {
    CHECK(channel.name != "variance.Y");
    CHECK(channel.name != "noisy.R");
    CHECK(channel.name != "diffuse_direct.R");
  }
  const auto depth = std::find_if(picture.channels.begin(), picture.channels.end(),
                                  [](const PictureChannel& channel) { return channel.name == "Z"; });
  REQUIRE(depth != picture.channels.end());
  CHECK(picture.values[std::size_t(depth - picture.channels.begin())] == 7);
}

TEST_CASE("a light group that lacks a channel is not left out in silence") {
  const TemporaryFolder folder;
  StoredLayers picture = read_layers(two_groups(folder));
  for (PictureChannel& channel : picture.channels)
    if (channel.name == "light_key.G") channel.name = "light_key.Q";
  CHECK_THROWS_WITH(relight(picture, {}, "two.exr"),
                    "two.exr: the light group \"key\" lacks one of its channels R, G and B");
}

TEST_CASE("relight says where a picture is denoised and its groups are not") {
  const TemporaryFolder folder;
  const std::string picture = quoted(folder.file("a.exr")), again = folder.file("b.exr");
  for (const bool are_denoised : {false, true}) {
    REQUIRE(run_program("render " + quoted(box_scene) +
                        " -r 16 12 -s 2 -q --layers=light-groups --denoise=own -o " + picture +
                        (are_denoised ? " --denoise-light-groups" : ""))
                .exit_code == 0);
    const ProcessResult result = run_program("relight " + picture + " -o " + quoted(again));
    CHECK(result.exit_code == 0);
    CHECK((result.err.find("its light groups are not denoised") == std::string::npos) == are_denoised);
    const ImageMetadata metadata = read_layers(again).metadata;
    CHECK(std::any_of(metadata.begin(), metadata.end(),
                      [](const auto& entry) { return entry.first == "twinray:denoiser"; }) == are_denoised);
  }
}

TEST_CASE("relight writes a picture, lists its groups, and says what it cannot do") {
  const TemporaryFolder folder;
  const std::string two = quoted(two_groups(folder));
  CHECK(run_program("relight " + two).out == "fill\nkey\n");
  const std::string out = folder.file("out.exr");
  REQUIRE(run_program("relight " + two + " --light=fill=0 -o " + quoted(out)).exit_code == 0);
  CHECK(read_image(out).pixels == std::vector<Rgb>{{1, 0, 0}, {0.5f, 0, 0.25f}});
  CHECK(light_groups_of(read_layers(out)) == std::vector<std::string>{"fill", "key"});
  const std::string png = folder.file("out.png");
  REQUIRE(run_program("relight " + two + " --light=key=0,0,0 -o " + quoted(png)).exit_code == 0);
  CHECK(read_image(png).pixels[0] == Rgb{0, 1, 0});

  const auto complaint = [&](const std::string& words) { return run_program("relight " + words).err; };
  CHECK(complaint(two + " --light=rim=2 -o a.png")
            .ends_with("it has no light group \"rim\"; there are fill, key\n"));
  CHECK(
      complaint(two + " --light=key=2").starts_with("twinray: --light: where to? --output=FILE is missing"));
  CHECK(contains(complaint(two + " --light=key=2 --light fill=1 --light=key=3 -o a.exr"),
                 "--light: key is named twice"));
  CHECK(complaint(two + " --light=key=0 -o " + two)
            .ends_with("two.exr: this file is read; choose another name\n"));
  const std::string around = folder.file("around.exr");
  REQUIRE(run_program("render " + quoted(box_scene) +
                      " -r 8 6 -s 1 -q --overscan=1 --layers=light-groups -o " + quoted(around))
              .exit_code == 0);
  CHECK(
      complaint(quoted(around) + " -o " + quoted(folder.file("around.png")))
          .ends_with("around.png: it cannot tell the picture's frame from what is around it; an .exr can\n"));
  CHECK(run_program("relight " + quoted(around) + " -o " + quoted(folder.file("again.exr"))).exit_code == 0);
  write_exr(folder.file("plain.exr"), Image(2, 2));
  CHECK(complaint(quoted(folder.file("plain.exr")))
            .ends_with("it has no light groups; a render with --layers=light-groups writes them\n"));
  CHECK(complaint(quoted(png)).ends_with("it holds no layers; an OpenEXR picture, .exr, may\n"));
}

TEST_CASE("a render's light groups, mixed as they are, are the render") {
  const TemporaryFolder folder;
  const std::string scene = TWINRAY_SOURCE_DIR "/scenes/lights.dae";
  const std::string picture = folder.file("lights.exr"), again = folder.file("again.exr");
  REQUIRE(run_program(fmt::format("{} -r 24 18 -s 4 -q --layers=all -o {}", scene, picture)).exit_code == 0);
  REQUIRE(run_program(fmt::format("relight {} -o {}", picture, again)).exit_code == 0);
  CHECK(read_image(again).pixels == read_image(picture).pixels);
  CHECK(light_groups_of(read_layers(again)).size() > 1);
  const std::string png = folder.file("again.png");
  REQUIRE(run_program(fmt::format("relight {} -o {}", picture, png)).exit_code == 0);
  CHECK(contains(read_text(again), "cryptomatte/"));
  CHECK_FALSE(contains(read_text(png), "cryptomatte/"));
  CHECK_FALSE(contains(read_text(png), "object_id"));
}

}  // namespace twinray::test

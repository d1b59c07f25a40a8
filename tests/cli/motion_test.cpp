// SPDX-License-Identifier: Apache-2.0
// Motion while the shutter is open, as a program.
#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "cli/moving_scene.h"
#include "cli/render_command_line.h"
#include "cli/render_scene.h"
#include "cli/render_talk.h"
#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/error_text.h"
#include "tests/support/json.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

namespace twinray::test {
namespace {

const std::string moving_wheel = quoted(TWINRAY_SOURCE_DIR "/scenes/motion.pbrt");
const std::string moving_box = quoted(TWINRAY_SOURCE_DIR "/tests/fuzz/seeds/gltf/moving.glb");

std::string in(const TemporaryFolder& folder, const std::string& name) { return quoted(folder.file(name)); }

/// Renders 40 x 24 pixels, and returns the file's bytes.
std::string motion_picture(const TemporaryFolder& folder, const std::string& words,
                           const std::string& scene = moving_wheel) {
  const ProcessResult result =
      run_program(fmt::format("render {} -r 40 24 -q {} -o {}", scene, words, in(folder, "made.pfm")));
  CHECK(result.err == "");
  REQUIRE(result.exit_code == 0);
  return read_text(folder.file("made.pfm"));
}

RenderArguments motion_arguments(const std::vector<std::string>& words) {
  RenderArguments arguments = parse_render_arguments(words);
  arguments.quiet = true;
  return arguments;
}

/// Where the camera of a scene stands at a time, and as the scene was read.
std::pair<Vec3, Vec3> camera_then_and_first(const std::vector<std::string>& words, double time) {
  RenderArguments arguments = motion_arguments(words);
  RenderTalk silence;
  const LoadedScene first = load_for_render(arguments, silence);
  return {load_for_moment(arguments, first, time).scene.camera.position, first.scene.camera.position};
}

std::string said_by(const std::string& words, int code = 0) {
  const ProcessResult result = run_program(words);
  CHECK(result.exit_code == code);
  return result.out + result.err;
}

}  // namespace

TEST_CASE("a picture of motion has the same bits by every engine, on any number of threads") {
  const TemporaryFolder folder;
  const std::string wanted = motion_picture(folder, "-s 6 --accel=bvh --threads=1");
  for (const std::string engine :
       {"--accel=embree --threads=2", "--accel=brute-force", "--accel=bvh --bvh-width=2 --simd=scalar",
        "--memory-mode=compact", "--integrator=path-reference"}) {
    CAPTURE(engine);
    CHECK(motion_picture(folder, "-s 6 " + engine) == wanted);
  }
  CHECK(motion_picture(folder, "-s 6 --time=0,0.5") == wanted);  // The file's own shutter.
  CHECK(motion_picture(folder, "-s 6 --time=0") != wanted);
  CHECK(motion_picture(folder, "-s 6 --time=0,0.5:6") != wanted);
}

TEST_CASE("a picture of motion goes on from a film, and its parts are merged, to the same bits") {
  const TemporaryFolder folder;
  const std::string wanted = motion_picture(folder, "-s 10"), film = in(folder, "a.film");
  const std::string begin = fmt::format("render {} -r 40 24 -q ", moving_wheel);
  REQUIRE(run_program(begin + "-s 5 -o " + film).exit_code == 0);
  REQUIRE(run_program(fmt::format("resume {} -s 10 -q -o {}", film, in(folder, "b.pfm"))).exit_code == 0);
  CHECK(read_text(folder.file("b.pfm")) == wanted);
  for (const char* range : {"0:3", "3:10"})
    REQUIRE(run_program(fmt::format("{}--of=10 --sample-range={} -o {}", begin, range,
                                    in(folder, range[0] + std::string(".film"))))
                .exit_code == 0);
  REQUIRE(run_program(fmt::format("merge {} {} -o {}", in(folder, "0.film"), in(folder, "3.film"),
                                  in(folder, "c.pfm")))
              .exit_code == 0);
  CHECK(read_text(folder.file("c.pfm")) == wanted);
}

TEST_CASE("a picture of motion is verified") {
  const TemporaryFolder folder;
  const std::string picture = in(folder, "a.exr");
  REQUIRE(run_program(fmt::format("render {} -r 40 24 -q -s 5 -o {}", moving_wheel, picture)).exit_code == 0);
  CHECK(contains(said_by("verify " + picture + " --seed=1"), "Same bits      6 of 6 tiles"));
}

TEST_CASE("each sample is replayed at its own moment") {
  const TemporaryFolder folder;
  const std::string words = "-s 2 --time=0,0.5:1 --filter=box";
  motion_picture(folder, words);
  const Rgb pixel = read_image(folder.file("made.pfm")).at(14, 10);
  const auto radiance = [&](int index) {
    const std::string json = folder.file("path.json");
    REQUIRE(run_program(fmt::format("render {} -r 40 24 {} -q --replay 14 10 {} --replay-json={}",
                                    moving_wheel, words, index, quoted(json)))
                .exit_code == 0);
    const auto sum = nlohmann::json::parse(read_text(json)).at("sum");
    return Rgb{sum[0], sum[1], sum[2]};
  };
  const std::string said =
      said_by(fmt::format("render {} -r 40 24 {} --replay 14 10 1", moving_wheel, words));
  CHECK(contains(said, fmt::format("  time             {:g} s\n", 0.5 * shutter_part(1, 0))));
  const Rgb first = radiance(0), second = radiance(1);
  CHECK(first != second);
  CHECK(pixel.r == Approx((first.r + second.r) / 2).epsilon(1e-6));
  CHECK(pixel.b == Approx((first.b + second.b) / 2).epsilon(1e-6));
}

TEST_CASE("glTF moves while the shutter is open") {
  const TemporaryFolder folder;
  const std::string at_once = motion_picture(folder, "-s 4 --time=0.25", moving_box);
  CHECK(motion_picture(folder, "-s 4 --time=0.25,0.75", moving_box) != at_once);
  const std::string said =
      said_by(fmt::format("render {} -r 8 6 -s 1 --time=0.25,0.75 -o {}", moving_box, in(folder, "a.png")));
  CHECK(contains(said, "animation: 0 to 1 s, the shutter is open from 0.25 to 0.75 s\n"));
}

TEST_CASE("a file's own shutter is told, and gives way to a time") {
  const TemporaryFolder folder;
  const std::string rest = " -r 8 6 -s 1 -o " + in(folder, "a.png");
  CHECK(contains(said_by("render " + moving_wheel + rest),
                 "animation: 0 to 0.5 s, the shutter is open from 0 to 0.5 s\n"));
  CHECK(contains(said_by("render " + moving_wheel + " --time=0.5" + rest),
                 "animation: 0 to 0.5 s, shown at 0.5 s\n"));
  CHECK(contains(said_by("info " + moving_wheel),
                 "animation: 0 to 0.5 s, the shutter is open from 0 to 0.5 s\n"));
  CHECK(contains(
      said_by("convert " + moving_wheel + " " + in(folder, "a.json")),
      "warning: motion is not written: all stands as when the shutter opens; --time=T is another moment"));
}

TEST_CASE("a camera that is not the file's stays while the scene moves") {
  const TemporaryFolder folder;
  const std::string panned = folder.file("panned.pbrt");
  write_text(panned,
             "ActiveTransform EndTime Translate -2 0 0 ActiveTransform All Camera \"perspective\" WorldBegin "
             "ActiveTransform EndTime Translate 9 0 0 ActiveTransform All Shape \"sphere\"");
  const auto [moved, begun] = camera_then_and_first({panned}, 0.5);
  CHECK(begun == Vec3{0, 0, 0});
  CHECK(moved == Vec3{1, 0, 0});
  const auto [whole, first_whole] = camera_then_and_first({panned, "--view=whole"}, 0.5);
  CHECK(whole == first_whole);
  const auto [usual, first_usual] =
      camera_then_and_first({TWINRAY_SOURCE_DIR "/tests/fuzz/seeds/gltf/moving.glb"}, 1);
  CHECK(usual == first_usual);
}

TEST_CASE("a scene whose file changes while it is rendered is an error, with its time") {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.pbrt");
  const std::string moving = "WorldBegin ActiveTransform EndTime Translate 9 0 0 Shape \"sphere\"";
  write_text(path, moving);
  RenderArguments arguments = motion_arguments({path, "--time=1,2", "--accel=bvh"});
  arguments.load.files = std::make_shared<std::vector<std::string>>();
  RenderTalk silence;
  const LoadedScene first = load_for_render(arguments, silence);
  MovingScene scene(arguments, first);
  CHECK(error_text([&] { scene.at(0.25); }).empty());
  CHECK(scene.at(0).scene.geometry->sphere_count() == 1);
  write_text(path, moving + " Shape \"sphere\"");
  CHECK(error_text([&] { scene.at(0.25); }) ==
        "at 1.25 s: " + path + ": it was changed after the render had begun");
}

TEST_CASE("each sample sees its own moment, but where reading and building a scene takes long") {
  RenderTalk silence;
  RenderArguments few = motion_arguments({TWINRAY_SOURCE_DIR "/scenes/motion.pbrt"});
  load_for_render(few, silence);
  CHECK(few.samples_per_moment == 1);
  const TemporaryFolder folder;
  const std::string path = folder.file("many.pbrt");
  write_text(path,
             "WorldBegin ActiveTransform EndTime Translate 9 0 0 ActiveTransform All Shape \"loopsubdiv\" "
             "\"integer levels\" 7 \"point3 P\" [ 1 1 1  1 -1 -1  -1 1 -1  -1 -1 1 ] "
             "\"integer indices\" [ 0 1 2  0 3 1  0 2 3  1 3 2 ]");
  RenderArguments many = motion_arguments({path});
  load_for_render(many, silence);
  CHECK(many.samples_per_moment == 4);
  RenderArguments asked = motion_arguments({path, "--time=0,1:2"});
  load_for_render(asked, silence);
  CHECK(asked.samples_per_moment == 2);
}

TEST_CASE("a render that fails at a later moment leaves its samples in the checkpoint") {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.pbrt"), film = folder.file("a.film");
  // A triangle that grows: from three quarters of the time on its corners are too far away. That is so of the
  // third moment, at 0.85, and not of those before it, at 0.60 and 0.10.
  REQUIRE(shutter_part(2, 0) > 0.8);
  REQUIRE(shutter_part(0, 0) < 0.7);
  write_text(
      path,
      "WorldBegin LightSource \"infinite\" ActiveTransform EndTime Scale 1.3333e12 1.3333e12 1.3333e12 "
      "Shape \"trianglemesh\" \"point3 P\" [ 0 0 1  1 0 1  0 1 1 ]");
  const ProcessResult result =
      run_program(fmt::format("render {} -r 8 6 -s 64 -q --time=0,1 --checkpoint={} -o {}", quoted(path),
                              quoted(film), in(folder, "a.png")));
  INFO(result.err);
  CHECK(result.exit_code == 1);
  CHECK(contains(result.err, "at 0.853085 s: " + path + ":1:"));
  // It has what a picture of two samples needs.
  CHECK(said_by("resume " + quoted(film) + " -s 2 -q -o " + in(folder, "b.png")).empty());
}

TEST_CASE("the light of an option is that of every moment, and so are groups of lights") {
  const TemporaryFolder folder;
  const std::string sky = folder.file("sky.pfm");
  write_text(sky, "PF\n2 1\n-1.0\n" + std::string(2 * 3 * sizeof(float), 1));
  RenderArguments arguments = motion_arguments({TWINRAY_SOURCE_DIR "/scenes/motion.pbrt", "-e", sky,
                                                "--layers=light-groups", "--default-light=always"});
  RenderTalk silence;
  const LoadedScene first = load_for_render(arguments, silence);
  const LoadedScene then = load_for_moment(arguments, first, 0.25);
  REQUIRE(then.scene.lights.size() == first.scene.lights.size());
  CHECK(then.scene.light_groups == first.scene.light_groups);
  CHECK(first.scene.light_groups.size() > 2);
  const auto map_of = [&](const Scene& scene) {
    for (const Light& light : scene.lights)
      if (const auto* found = std::get_if<EnvironmentLight>(&light.source);
          found && light.name == "environment")
        return found->map;
    return std::shared_ptr<const Image>();
  };
  CHECK(map_of(first.scene));
  CHECK(map_of(then.scene) == map_of(first.scene));
}

TEST_CASE("what needs a still scene says so of motion") {
  const TemporaryFolder folder;
  const std::string rest = " -r 8 6 -s 4 -q -o " + in(folder, "a.png");
  const auto said = [&](const std::string& words, int code) {
    return said_by("render " + moving_wheel + " " + words + rest, code);
  };
  CHECK(contains(said("--time=0,0.5 --adaptive 2 0.1", 2),
                 "--time: --adaptive needs a scene that stands still"));
  CHECK(contains(said("--time=0,0.5 --allocation=error", 2),
                 "--time: --allocation=error needs a scene that stands still"));
  CHECK(contains(said("--time=0,0.5 --accel=check", 2),
                 "--time: --accel=check needs a scene that stands still"));
  CHECK(said("--adaptive 2 0.1", 0) ==
        "warning: --adaptive: nothing moves, all stands as when the shutter opens; --time=T says so\n");
  CHECK(said("--time=0 --adaptive 2 0.1", 0).empty());
  CHECK(said_by("render " + quoted(TWINRAY_SOURCE_DIR "/scenes/box.dae") + " --time=0,1" + rest) ==
        "warning: --time: no effect, for nothing in the scene moves\n");
}

TEST_CASE("a time is one moment, or two and samples of each, and nothing else") {
  const auto parsed = [](const std::string& word) { return motion_arguments({"a.glb", "--time=" + word}); };
  const auto fault = [&](const std::string& word) { return error_text([&] { parsed(word); }); };
  CHECK(parsed("0.5").load.time == 0.5);
  CHECK(!parsed("0.5").shutter);
  CHECK(parsed("-1,2").load.time == -1);
  CHECK(parsed("-1,2").shutter == Shutter{-1, 2});
  CHECK(parsed("-1,2").samples_per_moment == 0);
  CHECK(parsed("0,1:16").samples_per_moment == 16);
  CHECK(fault("1,1") == "--time: 1 is not less than 1");
  CHECK(fault("2,1") == "--time: 2 is not less than 1");
  CHECK(fault("2:4") == "--time: 2 is one moment; END is missing before the samples of each");
  for (const char* wrong : {"", "soon", "0,", "0,1:", "0,1:0", "0,1:many", "0,1,2", "nan", "0,1e99"})
    CHECK(!fault(wrong).empty());
}

}  // namespace twinray::test

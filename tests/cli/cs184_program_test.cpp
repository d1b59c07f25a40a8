// SPDX-License-Identifier: Apache-2.0
// CS184's program as its users see it: printed lines, names of files, exit codes.
#include <fmt/format.h>

#include <filesystem>
#include <regex>

#include "io/cs184/picture.h"
#include "tests/support/catch.h"
#include "tests/support/cs184_scene.h"

namespace twinray::test {
namespace {

bool matches(const std::string& text, const std::string& pattern) {
  return std::regex_match(text, std::regex(pattern));
}

/// The one text between two others.
std::string between(const std::string& text, const std::string& before, const std::string& behind) {
  const std::size_t begin = text.find(before);
  if (begin == text.npos) return "";
  const std::size_t end = text.find(behind, begin + before.size());
  return end == text.npos ? "" : text.substr(begin + before.size(), end - begin - before.size());
}

const std::string small_cs184 = "-r 16 12 -f picture.png ";

}  // namespace

TEST_CASE("the lines of CS184's program are printed in its order, on its streams") {
  const TemporaryFolder folder;
  const ProcessResult result = run_cs184(folder, lit_floor(), small_cs184);
  REQUIRE(result.exit_code == 0);
  CHECK(matches(result.out,
                "\\[PathTracer\\] Collecting primitives\\.\\.\\. Done! \\(\\d+\\.\\d{4} sec\\)\n"
                "\\[PathTracer\\] Building BVH from 4 primitives\\.\\.\\. Done! \\(\\d+\\.\\d{4} sec\\)\n"
                "\\[PathTracer\\] Rendering\\.\\.\\. (\r\\[PathTracer\\] Rendering\\.\\.\\. \\d+%)*"
                "\r\\[PathTracer\\] Rendering\\.\\.\\. 100%! \\(\\d+\\.\\d{4}s\\)\n"
                "\\[PathTracer\\] BVH traced \\d+ rays\\.\n"
                "\\[PathTracer\\] Average speed \\d+\\.\\d{4} million rays per second\\.\n"
                "\\[PathTracer\\] Averaged \\d+\\.\\d{6} intersection tests per ray\\.\n"
                "\\[PathTracer\\] Job completed\\.\n"));
  CHECK(result.err ==
        "[PathTracer] Input scene file: scene.dae\n"
        "[PathTracer] Rendering using 1 threads\n"
        "[PathTracer] Saving to file: picture.png... Done!\n");
}

TEST_CASE("CS184's program writes what happens on a path, too") {
  const TemporaryFolder folder;
  const ProcessResult result = run_cs184(folder, lit_floor(), "-r 16 12 -s 2 --replay 8 6 1");
  CHECK(result.exit_code == 0);
  CHECK(result.out.starts_with("Pixel 8 6, sample 1 of 2: scene.dae, 16 x 12 pixels"));
}

TEST_CASE("with another engine the lines name what was built") {
  const TemporaryFolder folder;
  const ProcessResult brute = run_cs184(folder, lit_floor(), small_cs184 + "--accel=brute-force -m 0 ");
  CHECK(brute.out.find("[PathTracer] Building brute-force from 4 primitives... Done! (") !=
        std::string::npos);
  CHECK(brute.out.find("[PathTracer] brute-force traced 192 rays.\n") != std::string::npos);
  CHECK(brute.out.find("[PathTracer] Averaged 4.000000 intersection tests per ray.\n") != std::string::npos);
#ifdef TWINRAY_WITH_EMBREE
  const ProcessResult native = run_cs184(folder, lit_floor(), small_cs184 + "--accel=embree-native ");
  CHECK(native.out.find("[PathTracer] No intersection tests were counted.\n") != std::string::npos);
  CHECK(native.out.find("Averaged") == std::string::npos);
#endif
  const ProcessResult fastest = run_cs184(folder, lit_floor(), small_cs184 + "--accel=auto ");
  CHECK(fastest.out.find("[PathTracer] No intersection tests were counted.\n") != std::string::npos);
}

TEST_CASE("a cell, camera settings and an environment have lines of their own") {
  const TemporaryFolder folder;
  write_text(
      folder.file("cam.txt"),
      "50 35 1.333333 0.01 100\n0 2 6\n0 0 0\n1 0 6 0.1 100\n1 0 0\n0 1 0\n0 0 1\n800 600 952\n4.7 0\n");
  Image sky(4, 2);
  for (Rgb& pixel : sky.pixels) pixel = {1, 1, 1};
  write_exr(folder.file("sky.exr"), sky);
  const ProcessResult result =
      run_cs184(folder, lit_floor(), small_cs184 + "-p 0 0 8 4 -c cam.txt -e sky.exr -t 2 ");
  REQUIRE(result.exit_code == 0);
  CHECK(result.out.find("[PathTracer] Loading environment map sky.exr\n"
                        "[PathTracer] Initializing environment light...done.\n"
                        "[Camera] Loaded settings from cam.txt\n"
                        "[PathTracer] Collecting primitives... ") == 0);
  CHECK(result.out.ends_with("[PathTracer] Cell job completed.\n"));
  CHECK(result.err.find("[PathTracer] Rendering using 2 threads\n") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(folder.file("probability_debug.png")));
  CHECK(read_image(folder.file("picture.png")).width == 8);
  CHECK(read_image(folder.file("picture_rate.png")).width == 16);
}

TEST_CASE("progress never stops short of 100 per cent, and never goes back") {
  const TemporaryFolder folder;
  const ProcessResult result = run_cs184(folder, lit_floor(), "-r 480 36 -s 2 -f picture.png ");
  int last = -1;
  const std::regex percent("Rendering\\.\\.\\. (\\d+)%");
  for (auto it = std::sregex_iterator(result.out.begin(), result.out.end(), percent);
       it != std::sregex_iterator(); ++it) {
    CHECK(std::stoi((*it)[1]) > last);
    last = std::stoi((*it)[1]);
  }
  CHECK(last == 100);
}

TEST_CASE("the ending of -f decides the format, and a name without one is a PNG") {
  const TemporaryFolder folder;
  for (const char* name : {"a.png", "a", "a.b.PNG", "floor_0.05", "a."}) {
    REQUIRE(run_cs184(folder, lit_floor(), fmt::format("-r 16 12 -f {} ", name)).exit_code == 0);
    CHECK(read_text(folder.file(name)).substr(1, 3) == "PNG");
  }
  REQUIRE(run_cs184(folder, lit_floor(), "-r 16 12 -f b.exr ").exit_code == 0);
  CHECK(read_image(folder.file("b.exr")).height == 12);
  const ProcessResult gif = run_cs184(folder, lit_floor(), "-r 16 12 -f c.gif ");
  CHECK(gif.exit_code == 1);
  CHECK(gif.err.find(
            "c.gif: a picture's name must end in .png, .jpg, .jpeg, .exr, .tif, .tiff, .hdr or .pfm") !=
        std::string::npos);
}

TEST_CASE("a picture of sample rates has the picture's name without its last four characters") {
  const TemporaryFolder folder;
  for (const auto& [name, rates] : {std::pair{"a.png", "a_rate.png"},
                                    {"a6", "a6_rate.png"},
                                    {"image", "i_rate.png"},
                                    {"b.exr", "b_rate.png"}}) {
    REQUIRE(run_cs184(folder, lit_floor(), fmt::format("-r 16 12 -f {} ", name)).exit_code == 0);
    CHECK(read_image(folder.file(rates)).width == 16);
  }
}

TEST_CASE("without -f the picture has the name of a screenshot, and the program says so") {
  const TemporaryFolder folder;
  const ProcessResult result = run_cs184(folder, lit_floor(), "-r 16 12 ");
  REQUIRE(result.exit_code == 0);
  const std::string name = between(result.err, "[PathTracer] Saving to file: ", "... Done!");
  CHECK(matches(name, "scene_screenshot_\\d{1,2}-\\d{1,2}_\\d{1,2}-\\d{1,2}-\\d{1,2}\\.png"));
  CHECK(result.err.find(fmt::format(
            "[PathTracer] There is no -f, and this program opens no window: it renders to {}\n", name)) == 0);
  CHECK(read_image(folder.file(name)).width == 16);
}

TEST_CASE("the same program answers to --cs184, and to its second name without a word more") {
  const TemporaryFolder folder;
  REQUIRE(run_cs184(folder, lit_floor(), "-r 16 12 -s 2 -f a.exr ").exit_code == 0);
  const std::string scene = fmt::format("'{}'", folder.file("scene.dae"));
  for (const char* command : {"--cs184 -r 16 12 -s 2", "render -r 16 12 --cs184 -s 2"}) {
    const ProcessResult result =
        run_program(fmt::format("{} -f '{}' {}", command, folder.file("b.exr"), scene));
    CHECK(result.exit_code == 0);
    CHECK(read_image(folder.file("a.exr")).pixels == read_image(folder.file("b.exr")).pixels);
  }
  const std::string all = "-s 4 -l 2 -t 2 -m 3 -o 0 -H -a 2 0.1 -r 32 24 -p 4 2 16 8 -b 0.1 -d 3 ";
  REQUIRE(run_cs184(folder, lit_floor(), all + "-f a.exr ").exit_code == 0);
  REQUIRE(run_program(fmt::format("--cs184 {} {} -f '{}'", scene, all, folder.file("b.exr"))).exit_code == 0);
  CHECK(read_image(folder.file("a.exr")).pixels == read_image(folder.file("b.exr")).pixels);
  CHECK(run_program("stats --cs184 " + scene).exit_code == 2);
}

TEST_CASE("help is the usage text of CS184's program, and no error") {
  for (const char* words : {"-h", "-s 4 -h", "-h no-such-scene.dae"}) {
    const ProcessResult help = run_shell(fmt::format("'{}' {}", TWINRAY_PATHTRACER, words));
    CHECK(help.exit_code == 0);
    CHECK(help.err.empty());
    CHECK(help.out.find("Usage: " TWINRAY_PATHTRACER " [options] <scenefile>\n"
                        "Program Options:\n"
                        "  -s  <INT>        Number of camera rays per pixel\n") == 0);
    CHECK(help.out.ends_with("\n\n"));
  }
}

TEST_CASE("a wrong command line prints the usage on standard output, the reason beside it, and ends with 2") {
  for (const auto& [words, reason] : {std::pair{"", "SCENE is missing"},
                                      {"-z scene.dae", "there is no option -z"},
                                      {"scene.dae -s", "-s: INT is missing"},
                                      {"-r 64 -f x.png scene.dae", "-r: 2 numbers are needed, not 1"},
                                      {"a.dae b.dae", "\"b.dae\" is one word too many"}}) {
    const ProcessResult result = run_shell(fmt::format("'{}' {}", TWINRAY_PATHTRACER, words));
    INFO(words);
    CHECK(result.exit_code == 2);
    CHECK(result.out.find("Usage: ") == 0);
    CHECK(result.err.find(fmt::format("pathtracer: {}", reason)) == 0);
  }
}

TEST_CASE("an old picture survives a scene that cannot be read") {
  const TemporaryFolder folder;
  write_text(folder.file("old.png"), "old");
  const ProcessResult result = run_shell(
      fmt::format("cd '{}' && '{}' -f old.png none.dae", folder.path().string(), TWINRAY_PATHTRACER));
  CHECK(result.exit_code == 1);
  CHECK(result.err.find("[PathTracer] Input scene file: none.dae\npathtracer: none.dae") == 0);
  CHECK(read_text(folder.file("old.png")) == "old");
}

TEST_CASE("a picture on standard output leaves that to it, and rates out") {
  const TemporaryFolder folder;
  const ProcessResult result = run_cs184(folder, lit_floor(), "-r 16 12 -f - ");
  CHECK(result.exit_code == 0);
  CHECK(result.out.substr(1, 3) == "PNG");
  CHECK(result.err.find("[PathTracer] Job completed.\n") != std::string::npos);
  CHECK(folder.file_count() == 1);  // the scene
}

TEST_CASE("option -b is a lens that blurs what is not at the distance of -d") {
  // A wall that faces the camera at a distance of 1.5 times its diagonal; the cell lies across its edge.
  Cs184Scene wall;
  wall.geometries = cs184_geometry("floor", {4, "-1 -1 0 1 -1 0 1 1 0 -1 1 0", 2, "0 1 2 0 2 3", ""});
  wall.camera_matrix = moved_by("0", "0", "2");
  const std::string options = "--integrator=normals -r 480 440 -s 16 -p 0 200 240 8 ";
  const auto blurred = [&](const std::string& lens) {
    int count = 0;
    for (const Rgb& pixel : cs184_picture(wall, options + lens).pixels)
      count += pixel.r > 0.01f && pixel.r < 0.49f;
    return count;
  };
  CHECK(blurred("-d 2") <= 16);  // a pinhole: the edge alone
  CHECK(blurred("-b 0.5 -d 4.2426407") <= 16);
  CHECK(blurred("-b 0.5 -d 2") > 400);
}

TEST_CASE("camera settings give the view, and -b and -d the lens whatever the settings say") {
  const auto settings = [](const std::string& lens) {
    return "50 35 1.333333 0.01 100\n0 2 6\n0 0 0\n1 0 6 0.1 100\n1 0 0\n0 1 0\n0 0 1\n800 600 952\n" + lens;
  };
  const TemporaryFolder folder;
  write_text(folder.file("pinhole.txt"), settings("4.7 0\n"));
  write_text(folder.file("wide.txt"), settings("2 0.5\n"));
  const auto picture = [&](const std::string& options) {
    const ProcessResult result =
        run_cs184(folder, lit_floor(), "--integrator=normals -r 64 48 -s 4 -f a.exr " + options);
    if (result.exit_code != 0) throw Error(result.err);
    return read_image(folder.file("a.exr")).pixels;
  };
  const auto pinhole = picture("-c pinhole.txt");
  CHECK(picture("-c wide.txt") == pinhole);
  CHECK_FALSE(picture("") == pinhole);
  CHECK_FALSE(picture("-b 0.5 -d 2 -c pinhole.txt") == pinhole);
  CHECK(picture("-b 0.5 -d 2 -c wide.txt") == picture("-c pinhole.txt -b 0.5 -d 2"));
}

TEST_CASE("rays that miss the scene see the environment, turned as in CS184's program") {
  Image sky(8, 4);
  for (int y = 0; y < 4; ++y) sky.at(6, y) = {1, 0, 0}, sky.at(5, y) = {0, 0, 1};
  const TemporaryFolder folder;
  write_exr(folder.file("sky.exr"), sky);
  Cs184Scene speck = lit_floor();
  speck.geometries = cs184_geometry("floor", {3, "0 0 0 0.1 0 0 0 0 0.1", 1, "0 1 2", ""});
  speck.camera_matrix = moved_by("0", "0", "4");  // looks along -z, which is 3/4 of the way from the left
  REQUIRE(run_cs184(folder, speck, "-r 65 48 -m 0 -e sky.exr -f a.exr").exit_code == 0);
  const Image picture = read_image(folder.file("a.exr"));
  CHECK(picture.at(0, 2).r > picture.at(0, 2).b);
  CHECK(picture.at(64, 2).r < picture.at(64, 2).b);
  CHECK(picture.at(32, 2).r == Approx(picture.at(32, 2).b).margin(1e-4));
}

TEST_CASE("clip distances of the file cut the view, as distances along each ray") {
  Cs184Scene cut = lit_floor();
  cut.zfar = "8.485";  // how far the middle of the floor is, in the middle of the picture
  const auto black = [](const Image& image) {
    return std::count(image.pixels.begin(), image.pixels.end(), Rgb{});
  };
  CHECK(black(cs184_picture(lit_floor(), "--integrator=normals -r 60 44")) == 0);
  const Image half = cs184_picture(cut, "--integrator=normals -r 60 44");
  CHECK(black(half) > 60 * 44 * 4 / 10);
  CHECK(black(half) < 60 * 44 * 7 / 10);
  CHECK(half.at(30, 0) == Rgb{});         // behind
  CHECK_FALSE(half.at(30, 43) == Rgb{});  // in front
}

TEST_CASE("a PNG has CS184's tone curve, an EXR linear light") {
  const Image linear = cs184_picture(lit_floor(), "-r 16 12 -s 4");
  const TemporaryFolder folder;
  REQUIRE(run_cs184(folder, lit_floor(), "-r 16 12 -s 4 -f a.png").exit_code == 0);
  const Image png = read_image(folder.file("a.png"));
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 16; ++x)
      CHECK(int(encode_srgb(png.at(x, y).g)) == int(encode_cs184(linear.at(x, y).g)));
}

}  // namespace twinray::test

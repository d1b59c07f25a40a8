// SPDX-License-Identifier: Apache-2.0
// twinray render --replay, as a program.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/json.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

namespace twinray::test {
namespace {

using nlohmann::json;

const std::string replayed = "'" TWINRAY_SOURCE_DIR "/scenes/spheres.dae' ";
const std::string materials = "'" TWINRAY_SOURCE_DIR "/scenes/materials.pbrt' ";
const std::string replay_frame = "-r 48 36 -s 1 ";

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != text.npos; ++at) ++count;
  return count;
}

Rgb rgb_of(const json& list) { return {list[0], list[1], list[2]}; }

/// A floor under a lamp so strong and near that a sample of its light is no radiance any more.
const std::string glaring =
    "LookAt 0 3 1  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 0.2\n"
    "Film \"rgb\" \"integer xresolution\" 8 \"integer yresolution\" 6\nSampler \"independent\" "
    "\"integer pixelsamples\" 2\nWorldBegin\n"
    "LightSource \"point\" \"point3 from\" [ 0 0.0001 0 ] \"rgb I\" [ 1e8 1e8 1e8 ]\n"
    "Shape \"trianglemesh\" \"point3 P\" [ -9 0 -9  -9 0 9  9 0 9  9 0 -9 ] \"integer indices\" [ 0 1 2 0 2 "
    "3 ]\n";

/// A cube of ink, two units wide, of any boundary, above a floor; a lamp is where the camera is.
constexpr const char* inked_cube = R"(
LookAt 0 0 9  0 0 0  0 1 0
Camera "perspective" "float fov" 0.001
Film "rgb" "integer xresolution" 8 "integer yresolution" 6
WorldBegin
LightSource "point" "point3 from" [ 0 0 9 ]
Shape "trianglemesh" "point3 P" [ -9 -9 -2  9 -9 -2  9 9 -2 ]
MakeNamedMedium "ink" "string type" "homogeneous" "rgb sigma_a" [ 0 0.25 1 ] "rgb sigma_s" [ 0 0 0 ]
MediumInterface "ink" ""
Material {}
Shape "trianglemesh"
  "point3 P" [ -1 -1 -1  1 -1 -1  1 1 -1  -1 1 -1  -1 -1 1  1 -1 1  1 1 1  -1 1 1 ]
  "integer indices" [ 0 2 1 0 3 2 4 5 6 4 6 7 0 1 5 0 5 4 3 6 2 3 7 6 0 4 7 0 7 3 1 2 6 1 6 5 ]
)";

}  // namespace

TEST_CASE("a replayed sample is the pixel of a picture of one sample, by every way of finding light") {
  const TemporaryFolder folder;
  const std::string picture = folder.file("a.exr"), replay = folder.file("a.json");
  for (const std::string& scene : {replayed, materials})
    for (const std::string options :
         {"", "--direct=hemisphere -l 64 ", "--integrator=path-reference --seed 3 "}) {
      CAPTURE(scene, options);
      const std::string command = scene + replay_frame + options;
      REQUIRE(run_program(command + "-q -o " + quoted(picture)).exit_code == 0);
      const Image image = read_image(picture);
      for (const auto& [x, y] : {std::pair(24, 20), std::pair(10, 30)}) {
        const ProcessResult result =
            run_program(command + fmt::format("-q --replay {} {} 0 --replay-json ", x, y) + quoted(replay));
        CHECK(result.exit_code == 0);
        CHECK(result.out.empty());
        CHECK(result.err.empty());
        const json path = json::parse(read_text(replay));
        CHECK(rgb_of(path["sum"]) == image.at(x, y));
        CHECK(path["rendered"] == path["sum"]);
        CHECK_FALSE(is_black(rgb_of(path["sum"])));
      }
    }
}

TEST_CASE("a replay says in words what happens at each vertex, and why the path ends") {
  const ProcessResult result = run_program(replayed + replay_frame + "--replay 24 34 0");
  CHECK(result.exit_code == 0);
  CHECK(result.err.empty());
  CHECK(result.out.find("Pixel 24 34, sample 0 of 1: ") == 0);
  for (const char* part :
       {"48 x 36 pixels, seed 0, sampler sobol\n", "\nCamera\n  ray              from ", "\nVertex 1: shape ",
        "\n  point            ", "\n  geometric normal ", "\n  shading normal   ", "\n  uv               ",
        "\n  material         \"", "lambert, albedo ", "\n  light sample     \"", "(mesh): along ",
        "MIS weight ", "\n  adds             ", "\n  goes on          by diffuse reflection along ",
        "\n  density          ", "\n  throughput       1 1 1\n",
        "\nVertex 2: ", "\nThe path ends: ", "\nAll that it adds   "})
    CHECK(contains(result.out, part));
  const std::string sum = result.out.substr(result.out.find("All that it adds   ") + 19);
  CHECK(contains(sum, "\nRendered sample    " + sum.substr(0, sum.find('\n')) + "\n"));
}

TEST_CASE("a replay says what bodies on the way let through, with a boundary that refracts and without") {
  const TemporaryFolder folder;
  const std::string scene = folder.file("a.pbrt"), replay = folder.file("a.json");
  const auto replay_of = [&](const std::string& material, const char* depth) {
    write_text(scene, fmt::format(inked_cube, material));
    const ProcessResult result =
        run_program(quoted(scene) + depth + " -s 1 --replay 2 2 0 --replay-json " + quoted(replay));
    CHECK(result.exit_code == 0);
    CHECK(count_of(result.out, "\n  let through      ") == 1);
    return std::pair(result.out, json::parse(read_text(replay))["vertices"]);
  };
  const auto check_left = [](const json& transmittance) {
    CHECK(transmittance[0] == 1);
    CHECK(float(transmittance[1]) == Approx(std::exp(-0.5)).epsilon(1e-4));
    CHECK(float(transmittance[2]) == Approx(std::exp(-2.0)).epsilon(1e-4));
  };
  const auto [open, passed] = replay_of("\"interface\"", " -m 1");
  check_left(passed[0]["transmittance"]);
  CHECK(passed[0]["throughput"] == passed[0]["transmittance"]);
  CHECK(contains(open, "; visible, 1 0.6"));
  CHECK(contains(open, " let through on the way, scattered "));
  const auto [glass, inside] = replay_of("\"dielectric\" \"float eta\" 1.0001", " -m 2");
  CHECK(inside[0]["transmittance"] == json({1, 1, 1}));
  check_left(inside[1]["transmittance"]);
}

TEST_CASE("a replay says what media on the way have emitted") {
  const TemporaryFolder folder;
  const std::string scene = folder.file("a.pbrt"), replay = folder.file("a.json");
  write_text(
      scene,
      "MakeNamedMedium \"ember\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [ 50 50 50 ] \"rgb "
      "sigma_s\" "
      "[ 0 0 0 ] \"rgb Le\" [ 1 2 4 ] LookAt 0 0 9  0 0 0  0 1 0 Camera \"perspective\" \"float fov\" 0.001 "
      "Film \"rgb\" \"integer xresolution\" 8 \"integer yresolution\" 6 WorldBegin "
      "MediumInterface \"ember\" \"\" Material \"interface\" Shape \"sphere\"");
  const ProcessResult result =
      run_program(quoted(scene) + " -s 1 --replay 2 2 0 --replay-json " + quoted(replay));
  CHECK(result.exit_code == 0);
  CHECK(contains(result.out, "media glow       adds 1 2 4\n"));
  const json path = json::parse(read_text(replay));
  CHECK(path["vertices"][0]["glow"]["term"] == json({1, 2, 4}));
  CHECK(path["sum"] == json({1, 2, 4}));
}

TEST_CASE("a replay says where a medium has scattered the path") {
  const TemporaryFolder folder;
  const std::string scene = folder.file("a.pbrt"), replay = folder.file("a.json");
  write_text(
      scene,
      "MakeNamedMedium \"milk\" \"string type\" \"homogeneous\" \"float g\" 0.5 \"rgb sigma_a\" [ 0 0.5 0 ] "
      "\"rgb sigma_s\" [ 9 8.5 9 ] LookAt 0 0 9  0 0 0  0 1 0 Camera \"perspective\" \"float fov\" 0.001 "
      "Film \"rgb\" \"integer xresolution\" 8 \"integer yresolution\" 6 WorldBegin "
      "LightSource \"point\" \"point3 from\" [ 0 9 9 ] MediumInterface \"milk\" \"\" "
      "Material \"interface\" Shape \"sphere\"");
  const ProcessResult result =
      run_program(quoted(scene) + " -m 3 -s 1 --replay 2 2 0 --replay-json " + quoted(replay));
  CHECK(result.exit_code == 0);
  CHECK(contains(result.out, "Vertex 1: in a medium, "));
  CHECK(contains(result.out, " by bodies on the way, over the density of this point\n"));
  CHECK(contains(result.out, "scattering 9 8.5 9, absorption 0 0.5 0, anisotropy 0.5\n"));
  CHECK(contains(result.out, "goes on          by scattering in a medium along "));
  CHECK_FALSE(contains(result.out, "|cos|"));
  const json vertices = json::parse(read_text(replay))["vertices"];
  const json first = vertices[0];
  CHECK_FALSE(first["is_miss"]);
  CHECK(first["is_flight"]);
  CHECK_FALSE(first.contains("surface"));
  CHECK(first["medium"]["anisotropy"] == 0.5);
  CHECK(float(first["medium"]["point"][2]) < 1);
  CHECK(float(first["medium"]["point"][2]) > -1);
  // All channels lose the same, of which green absorbs 1 part in 18.
  CHECK(float(first["transmittance"][0]) == Approx(1).epsilon(1e-5));
  CHECK(float(first["transmittance"][1]) == Approx(8.5 / 9).epsilon(1e-5));
  CHECK(first["scattering"]["cosine"] == 1);
}

TEST_CASE("a replay says where a path goes below a surface, and where it comes out") {
  const TemporaryFolder folder;
  const std::string scene = folder.file("a.pbrt"), replay = folder.file("a.json");
  write_text(scene,
             "LookAt 0 0 9  0 0 0  0 1 0 Camera \"perspective\" \"float fov\" 0.001 "
             "Film \"rgb\" \"integer xresolution\" 8 \"integer yresolution\" 6 WorldBegin "
             "LightSource \"infinite\" Material \"subsurface\" \"float eta\" 1 "
             "\"rgb reflectance\" [ 0.5 0.5 0.5 ] \"rgb mfp\" [ 0.25 0.25 0.25 ] Shape \"sphere\"");
  const ProcessResult result =
      run_program(quoted(scene) + " -m 3 -s 1 --replay 2 2 0 --replay-json " + quoted(replay));
  CHECK(result.exit_code == 0);
  CHECK(contains(result.out, "goes on          by entering the body along "));
  CHECK(contains(result.out, "Vertex 2: out of the body, after "));
  CHECK(contains(result.out, " by the body, over the density of the walk\n"));
  const json vertices = json::parse(read_text(replay))["vertices"];
  CHECK_FALSE(vertices[0].contains("events_below"));
  CHECK(int(vertices[1]["events_below"]) > 0);
  // It absorbs the same of all channels.
  const float left = vertices[1]["transmittance"][0];
  CHECK((left > 0 && left < 1));
  CHECK(float(vertices[1]["throughput"][0]) == Approx(left).epsilon(1e-5));
  CHECK(vertices[1]["surface"]["model"] == "coated_diffuse");
}

TEST_CASE("a replay draws the path as lines from the camera to its vertices") {
  const TemporaryFolder folder;
  const std::string obj = folder.file("a.obj"), text = folder.file("a.json");
  REQUIRE(run_program(replayed + replay_frame + "-q --replay 16 29 0 --replay-obj " + quoted(obj) +
                      " --replay-json " + quoted(text))
              .exit_code == 0);
  const json path = json::parse(read_text(text));
  std::istringstream lines(read_text(obj));
  std::string line;
  const auto next_is = [&](const std::string& wanted) {
    REQUIRE(std::getline(lines, line));
    CHECK(line == wanted);
  };
  next_is("o path");
  const auto point = [](const json& p) {
    return fmt::format("v {} {} {}", p[0].get<float>(), p[1].get<float>(), p[2].get<float>());
  };
  next_is(point(path["vertices"][0]["ray"]["origin"]));
  std::size_t seen = 0, blocked = 0, surfaces = 0;
  for (const json& vertex : path["vertices"]) {
    if (!vertex.contains("surface")) continue;
    next_is(point(vertex["surface"]["point"]));
    ++surfaces;
    for (const json& sample : vertex["light_samples"]) {
      const bool is_seen = !is_black(rgb_of(sample["visibility"]));
      seen += is_seen;
      blocked += sample["is_traced"].get<bool>() && !is_seen;
    }
  }
  const std::string all = read_text(obj);
  const auto lines_of = [&](const std::string& object) {
    const std::size_t begin = all.find("o " + object + "\n");
    REQUIRE(begin != all.npos);
    return count_of(all.substr(begin, all.find("\no ", begin) - begin), "\nl ");
  };
  CHECK(lines_of("path") == 1);
  CHECK(lines_of("normals") == surfaces);
  CHECK(lines_of("light_samples") == seen);
  CHECK(lines_of("blocked_light_samples") == blocked);
}

TEST_CASE("JSON on standard output stands there alone") {
  const ProcessResult result = run_program(replayed + replay_frame + "--replay 1 1 0 --replay-json -");
  CHECK(result.exit_code == 0);
  CHECK(json::parse(result.out)["pixel"] == json({1, 1}));
  CHECK(contains(result.err, "The path ends: "));
}

TEST_CASE("a sample that is no radiance is rejected, counted, and named so that it can be replayed") {
  const TemporaryFolder folder;
  const std::string scene = folder.file("glaring.pbrt"), statistics = folder.file("a.json");
  write_text(scene, glaring);
  const ProcessResult render = run_program(quoted(scene) + " -q -o " + quoted(folder.file("a.exr")) +
                                           " --stats " + quoted(statistics));
  CHECK(render.exit_code == 0);
  CHECK(contains(render.err, " samples were rejected: not finite or beyond 1e+09. The first: pixel "));
  const json found = json::parse(read_text(statistics))["render"];
  CHECK(found["rejected_samples"].get<int>() > 0);
  const json first = found["first_rejected"];
  const std::string option = fmt::format("--replay {} {} {}", first["x"].get<int>(), first["y"].get<int>(),
                                         first["sample"].get<int>());
  CHECK(contains(render.err, "; " + option + " shows its path\n"));
  const ProcessResult replay = run_program(quoted(scene) + " -q " + option + " --replay-json -");
  CHECK(replay.exit_code == 0);
  CHECK(json::parse(replay.out)["rendered"][0].get<double>() > 1e9);
}

TEST_CASE("a sample that the picture does not have is an error that says which it has") {
  const auto said = [](const std::string& options) {
    const ProcessResult result = run_program(replayed + replay_frame + options);
    CHECK(result.exit_code == 2);
    return result.err.substr(0, result.err.find("\nusage"));
  };
  CHECK(said("--replay 48 0 0") ==
        "twinray: --replay: pixel 48 0 is not in the picture of 48 x 36 pixels; the last is 47 35");
  CHECK(said("--replay 0 36 0") ==
        "twinray: --replay: pixel 0 36 is not in the picture of 48 x 36 pixels; the last is 47 35");
  CHECK(run_program(replayed + "-r 48 36 -s 17 --allocation=error --replay 0 0 4000").exit_code == 0);
  CHECK(said("--replay 0 0 1") ==
        "twinray: --replay: sample 1 is not in the picture: of 1 samples a pixel the last is 0");
  CHECK(said("--replay 0 -1 0") == "twinray: --replay: \"-1\" is not a whole number from 0 to 65535");
  CHECK(said("--integrator=normals --replay 0 0 0") ==
        "twinray: --replay: --integrator=path, path-reference and direct alone trace paths");
  CHECK(said("--accel=check --replay 0 0 0") ==
        "twinray: --replay asks one engine alone; it does not go with --accel=check");
}

TEST_CASE("what has no effect on a replay, or without one, is named") {
  const TemporaryFolder folder;
  const ProcessResult result =
      run_program(replayed + replay_frame + "-t 2 --stats a.json --crop 0 0 9 9 --replay 1 1 0 -o " +
                  quoted(folder.file("a.png")));
  CHECK(result.exit_code == 0);
  for (const char* option : {"--output", "--stats", "--crop", "--threads"})
    CHECK(contains(result.err,
                   fmt::format("warning: {}: no effect, for --replay renders no picture\n", option)));
  CHECK(folder.file_count() == 0);
  // Nothing else was asked for.
  CHECK(contains(run_program(replayed + replay_frame + "-q --replay 1 1 0").out, "Pixel"));
  const ProcessResult without =
      run_program(replayed + replay_frame + "-q --replay-json b.json --replay-obj b.obj -o " +
                  quoted(folder.file("a.png")));
  CHECK(contains(without.err, "warning: --replay-json: no effect, for there is no --replay\n"));
  CHECK(contains(without.err, "warning: --replay-obj: no effect, for there is no --replay\n"));
}

}  // namespace twinray::test

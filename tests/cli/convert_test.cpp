// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstring>
#include <filesystem>

#include "cli/convert_command.h"
#include "core/error.h"
#include "core/image.h"
#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/json.h"
#include "tests/support/own_scenes.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

nlohmann::json read_json(const std::string& path) { return nlohmann::json::parse(read_text(path)); }

ConvertArguments parse_convert(const Words& words) {
  return parse_alone<ConvertArguments>(add_convert_options, words);
}

}  // namespace

TEST_CASE("convert writes a scene's files, and says how many") {
  const TemporaryFolder folder;
  const std::string path = folder.file("box.json");
  const ProcessResult result = run_program("convert " + box_scene + " " + quoted(path));
  CHECK(result.exit_code == 0);
  CHECK(result.err.empty());
  const auto json = read_json(path);
  const std::size_t shapes = json["shapes"].size();
  CHECK(result.out == fmt::format("{}: {} materials, {} light, {} shapes, {} files beside it\n", path,
                                  json["materials"].size(), json["lights"].size(), shapes, shapes));
  CHECK(folder.file_count() == 1 + shapes);
  for (const auto& shape : json["shapes"])
    CHECK(read_text(folder.file(shape["file"].get<std::string>())).starts_with("ply\n"));
  CHECK(json["shapes"][json["lights"][0]["shape"].get<std::size_t>()]["light"] == 0);
}

TEST_CASE("converting twice gives the same bytes") {
  const TemporaryFolder folder;
  const std::string path = folder.file("box.json");
  CHECK(run_program("convert -q " + box_scene + " " + quoted(path)).out.empty());
  const std::string text = read_text(path), mesh = read_text(folder.file("box-0.ply"));
  CHECK(run_program("convert -q " + box_scene + " " + quoted(path)).exit_code == 0);
  CHECK(read_text(path) == text);
  CHECK(read_text(folder.file("box-0.ply")) == mesh);
}

TEST_CASE("convert writes the camera for the view and the size that are asked for") {
  const TemporaryFolder folder;
  const std::string file = folder.file("file.json"), whole = folder.file("whole.json");
  CHECK(run_program("convert -q " + box_scene + " " + quoted(file)).exit_code == 0);
  CHECK(run_program("convert -q --view=whole -r 40 20 " + box_scene + " " + quoted(whole)).exit_code == 0);
  CHECK(read_json(file)["resolution"] == nlohmann::json({480, 360}));
  const auto json = read_json(whole);
  CHECK(json["resolution"] == nlohmann::json({40, 20}));
  const auto& camera = json["camera"];
  CHECK(camera["position"] != read_json(file)["camera"]["position"]);
  CHECK(camera["tan_half_width"].get<double>() == Approx(2 * camera["tan_half_height"].get<double>()));
}

TEST_CASE("convert writes an environment beside the scene") {
  const TemporaryFolder folder;
  Image map(2, 1);
  map.pixels = {{1, 2, 3}, {4, 5, 6}};
  write_exr(folder.file("sky.exr"), map);
  const std::string command = "convert -q -e " + quoted(folder.file("sky.exr")) + " " + box_scene + " ";
  CHECK(run_program(command + quoted(folder.file("a.json"))).exit_code == 0);
  const auto lights = read_json(folder.file("a.json"))["lights"];
  REQUIRE(lights.size() == 2);
  CHECK(lights[1]["type"] == "environment");
  CHECK(read_image(folder.file(lights[1]["file"].get<std::string>())).pixels[1].b == 6);
}

TEST_CASE("a wrong convert command line ends with 2, and a file that is not there or not writable with 1") {
  CHECK_THROWS_WITH(parse_convert({}), "SCENE is missing");
  CHECK_THROWS_WITH(parse_convert({"a.dae"}), "OUT is missing");
  CHECK_THROWS_WITH(parse_convert({"a.dae", "b.json", "c"}), "\"c\" is one word too many");
  CHECK_THROWS_WITH(parse_convert({"a.dae", "b.json", "-r", "0", "1"}),
                    "--resolution: \"0\" is not a whole number from 1 to 65536");
  CHECK(parse_convert({"a.dae", "b.json"}).view == View::file);
  const TemporaryFolder folder;
  const ProcessResult unknown = run_program("convert --vieww=file " + box_scene + " a.json");
  CHECK(unknown.exit_code == 2);
  CHECK(unknown.err ==
        "twinray: there is no option --vieww=file; did you mean --view?\n"
        "usage: twinray convert SCENE.dae OUT.json|.pbrt|.gltf|.glb [options]; all options: twinray convert "
        "--help\n");
  const ProcessResult output = run_program("convert " + box_scene + " -");
  CHECK(output.exit_code == 1);
  CHECK(output.err ==
        "twinray: -: a scene is written to a file whose name ends in .json, .pbrt, .gltf or .glb; other "
        "files of it are put beside it\n");
  const ProcessResult missing = run_program("convert no-such-scene.dae " + quoted(folder.file("a.json")));
  CHECK(missing.exit_code == 1);
  CHECK(missing.err.find("no-such-scene.dae") != std::string::npos);
  const ProcessResult nowhere =
      run_program("convert " + box_scene + " " + quoted(folder.file("none/a.json")));
  CHECK(nowhere.exit_code == 1);
  CHECK(nowhere.err ==
        fmt::format("twinray: {}: there is no folder {}\n", folder.file("none/a.json"), folder.file("none")));
  CHECK(folder.file_count() == 0);
}

TEST_CASE("convert writes nothing where one of its files cannot be written") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("box-1.ply"));
  const ProcessResult result = run_program("convert " + box_scene + " " + quoted(folder.file("box.json")));
  CHECK(result.exit_code == 1);
  CHECK(result.err.find("box-1.ply") != std::string::npos);
  CHECK(folder.file_count() == 1);
}

TEST_CASE("convert writes nothing where two of its files are the same place") {
  const TemporaryFolder folder;
  write_text(folder.file("box-0.ply"), "old");
  std::filesystem::create_symlink("box-0.ply", folder.file("box-1.ply"));
  const ProcessResult result = run_program("convert " + box_scene + " " + quoted(folder.file("box.json")));
  CHECK(result.exit_code == 1);
  CHECK(result.err == fmt::format("twinray: {}: the same place as {}; every output needs its own\n",
                                  folder.file("box-1.ply"), folder.file("box-0.ply")));
  CHECK(read_text(folder.file("box-0.ply")) == "old");
  CHECK(folder.file_count() == 2);
}

TEST_CASE("a picture of a scene that is converted is that of the scene") {
  const TemporaryFolder folder;
  const std::string scenes = TWINRAY_SOURCE_DIR "/scenes/";
  struct Case {
    const char *scene, *output;
    double tolerance;  ///< Of the mean: that of 8-bit pictures and spheres cut into triangles.
  };
  for (const auto& [scene, output, tolerance] :
       {Case{"spheres.dae", "a.pbrt", 0}, Case{"materials.pbrt", "b.pbrt", 0},
        Case{"spheres.dae", "c.gltf", 2e-3}, Case{"table.gltf", "d.glb", 5e-3}}) {
    INFO(output);
    const std::string path = folder.file(output);
    const auto mean = [&](const std::string& file) {
      const std::string picture = folder.file("picture.exr");
      const ProcessResult result = run_program("render -q -r 48 36 -s 16 -m 5 --filter=box " + quoted(file) +
                                               " -o " + quoted(picture));
      REQUIRE(result.exit_code == 0);
      return mean_of(read_image(picture));
    };
    const ProcessResult result = run_program("convert -q -r 48 36 " + scenes + scene + " " + quoted(path));
    REQUIRE(result.exit_code == 0);
    const Rgb wanted = mean(scenes + scene), converted = mean(path);
    CHECK(converted.r == Approx(wanted.r).epsilon(tolerance));
    CHECK(converted.g == Approx(wanted.g).epsilon(tolerance));
    CHECK(converted.b == Approx(wanted.b).epsilon(tolerance));
  }
}

TEST_CASE("a scene in exchange form renders to the bits of the scene that it was made of") {
  const std::string folder_of_scenes = TWINRAY_SOURCE_DIR "/scenes/";
  for (const std::string name : {"lights.dae", "spheres.dae", "still-life.pbrt", "pawns.pbrt", "layers.pbrt",
                                 "films.pbrt", "patterns.pbrt", "table.gltf"}) {
    INFO(name);
    const TemporaryFolder folder;
    const std::string converted = folder.file("a.json"), options = " -q -s 2 -m 3 --filter=box ";
    REQUIRE(run_program("convert -q -r 40 30 " + quoted(folder_of_scenes + name) + " " + quoted(converted))
                .exit_code == 0);
    REQUIRE(
        run_program(quoted(folder_of_scenes + name) + options + "-r 40 30 -o " + quoted(folder.file("a.pfm")))
            .exit_code == 0);
    const ProcessResult result =
        run_program(quoted(converted) + options + "-o " + quoted(folder.file("b.pfm")));
    CHECK(result.err.empty());
    CHECK(result.exit_code == 0);
    CHECK(read_text(folder.file("b.pfm")) == read_text(folder.file("a.pfm")));
  }
}

TEST_CASE("convert warns of what a format has not, and writes the files that it names") {
  const TemporaryFolder folder;
  const std::string path = folder.file("lights.gltf");
  const ProcessResult result =
      run_program("convert " TWINRAY_SOURCE_DIR "/scenes/lights.dae " + quoted(path));
  CHECK(result.exit_code == 0);
  CHECK(result.out == path + ": 4 materials, 8 lights, 8 shapes, 1 file beside it\n");
  std::string wanted;
  for (const char* line : {"a sphere light is a mesh that emits",
                           "a point light falls off with the square of the distance, not as the scene says",
                           "a spot light is as bright beside its axis as along it",
                           "an ambient light is left out", "5 spheres are meshes of 256 edges around"})
    wanted += fmt::format("warning: {}: {}\n", path, line);
  CHECK(result.err == wanted);
  CHECK(folder.file_count() == 2);
  CHECK(run_program("convert -q " + box_scene + " " + quoted(folder.file("box.glb"))).exit_code == 0);
  CHECK(folder.file_count() == 3);
  const ProcessResult dark = run_program("convert -q " TWINRAY_SOURCE_DIR "/scenes/blocks.obj " +
                                         quoted(folder.file("blocks.json")));
  CHECK(dark.err ==
        "warning: the scene has no light: a render adds a sky and a light at the camera, which are not "
        "written\n");
}

TEST_CASE("convert takes a file's own size of the picture, unless another one is asked for") {
  const TemporaryFolder folder;
  const std::string scene = folder.file("scene.pbrt"), path = folder.file("a.pbrt");
  write_text(scene,
             "Film \"rgb\" \"integer xresolution\" 64 \"integer yresolution\" 48 "
             "\"float cropwindow\" [ 0 0.5 0 1 ]\nWorldBegin\nShape \"sphere\"\n");
  CHECK(run_program("convert -q " + quoted(scene) + " " + quoted(path)).exit_code == 0);
  CHECK(read_text(path).find("\"integer xresolution\" [ 64 ]") != std::string::npos);
  CHECK(read_text(path).find("\"integer pixelbounds\" [ 0 32 0 48 ]") != std::string::npos);
  const auto other = [&](const std::string& name) {
    return run_program("convert " + quoted(scene) + " " + quoted(folder.file(name))).err;
  };
  CHECK(other("a.json").empty());
  CHECK(load_scene(folder.file("a.json")).defaults.crop == std::array{0, 0, 32, 48});
  CHECK(other("a.glb").find("a.glb: the picture's crop is left out\n") != std::string::npos);
  CHECK(run_program("convert -q -r 20 10 " + quoted(scene) + " " + quoted(path)).exit_code == 0);
  CHECK(read_text(path).find("\"integer xresolution\" [ 20 ]") != std::string::npos);
  CHECK(read_text(path).find("\"integer pixelbounds\" [ 0 10 0 10 ]") != std::string::npos);
}

TEST_CASE("convert keeps the clip distances of the camera") {
  const TemporaryFolder folder;
  const std::string scene = folder.file("a.dae"), json = folder.file("a.json");
  std::string text = read_text(box_scene);
  const std::size_t far = text.find("<zfar>");
  REQUIRE(far != std::string::npos);
  text.replace(far, text.find("</zfar>") - far, "<zfar>4");
  write_text(scene, text);
  const auto converted = [&](const std::string& from, const std::string& to) {
    return run_program("convert -q " + quoted(from) + " " + quoted(to)).err;
  };
  CHECK(converted(scene, json).empty());
  CHECK(converted(json, folder.file("b.json")).empty());
  CHECK(converted(scene, folder.file("a.glb")).empty());
  CHECK(converted(scene, folder.file("a.pbrt")).find("the camera's clip distances are left out") !=
        std::string::npos);
  for (const char* name : {"a.json", "b.json", "a.glb"}) {
    CHECK(load_scene(folder.file(name), {.clip_as_file = true}).scene.camera.clip_far == 4);
    CHECK(load_scene(folder.file(name)).scene.camera.clip_far > 1e30);
  }
}

TEST_CASE("convert writes what moves where it stands at a time") {
  const TemporaryFolder folder;
  const std::string scene = folder.file("scene.gltf");
  // A triangle whose node moves from x = 0 to x = 2 within a second: times, places and positions in base64.
  write_text(scene, R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 2}}]}],
    "animations": [{"samplers": [{"input": 0, "output": 1}],
                    "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 2, "type": "SCALAR"},
                  {"bufferView": 0, "byteOffset": 8, "componentType": 5126, "count": 2, "type": "VEC3"},
                  {"bufferView": 0, "byteOffset": 32, "componentType": 5126, "count": 3, "type": "VEC3"}],
    "bufferViews": [{"buffer": 0, "byteLength": 68}],
    "buffers": [{"byteLength": 68, "uri": "data:application/octet-stream;base64,BASE64"}]})");
  std::string text = read_text(scene);
  const std::string data =
      "AAAAAAAAgD8AAAAAAAAAAAAAAAAAAABAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAA=";
  text.replace(text.find("BASE64"), 6, data);
  write_text(scene, text);
  const std::string path = folder.file("a.json");
  CHECK(run_program("convert -q --time=0.5 " + quoted(scene) + " " + quoted(path)).exit_code == 0);
  const std::string mesh = read_text(folder.file("a-0.ply"));
  float x = 0;
  std::memcpy(&x, mesh.data() + mesh.find("end_header\n") + 11, sizeof x);
  CHECK(x == 1);
  const ProcessResult still =
      run_program("convert -q --time=0.5 " + box_scene + " " + quoted(folder.file("box.json")));
  CHECK(still.err == "warning: --time: no effect, for nothing in the scene moves\n");
  CHECK(run_program("convert --time=soon " + box_scene + " a.json").exit_code == 2);
}

TEST_CASE("convert says where the place of an environment has no effect, and which names JSON cannot keep") {
  const TemporaryFolder folder;
  const std::string scale = "convert -q " + box_scene + " " + quoted(folder.file("a.json"));
  CHECK(run_program(scale + " --environment-scale=2 --environment-layout=panorama").err ==
        "warning: --environment-layout: no effect, for there is no --environment\n"
        "warning: --environment-scale: no effect, for there is no --environment\n");
  const std::size_t files = folder.file_count();
  const ProcessResult named =
      run_program("convert -q " + box_scene + " " + quoted(folder.file("n\xff.json")));
  CHECK(named.exit_code == 1);
  CHECK(named.err.find("this name is not UTF-8") != std::string::npos);
  CHECK(folder.file_count() == files);
}

TEST_CASE("convert writes over no file that the scene is made of") {
  const TemporaryFolder folder;
  for (const auto& [name, found] : {std::pair{"box.pbrt", "box-pbrt-0.ply"}, {"box.json", "box-0.ply"}}) {
    const std::string scene = folder.file(name);
    REQUIRE(run_program("convert -q " + box_scene + " " + quoted(scene)).exit_code == 0);
    const std::string text = read_text(scene);
    const std::size_t files = folder.file_count();
    const ProcessResult result = run_program("convert " + quoted(scene) + " " + quoted(scene));
    CHECK(result.exit_code == 1);
    CHECK(result.err ==
          fmt::format("twinray: {}: this file is read; choose another name\n", folder.file(found)));
    CHECK(read_text(scene) == text);
    CHECK(folder.file_count() == files);
    CHECK(run_program("convert -q " + quoted(scene) + " " + quoted(folder.file("box.glb"))).exit_code == 0);
  }
}

TEST_CASE("a scene may be written in every format into one folder") {
  const TemporaryFolder folder;
  const std::string scene = quoted(TWINRAY_SOURCE_DIR "/scenes/table.gltf");
  std::map<std::string, std::string> files;
  for (const std::string name : {"a.json", "a.pbrt", "a.gltf"}) {
    REQUIRE(run_program("convert -q " + scene + " " + quoted(folder.file(name))).exit_code == 0);
    for (const auto& [file, text] : files) CHECK(read_text(folder.file(file)) == text);
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
      files.emplace(entry.path().filename().string(), read_text(entry.path().string()));
  }
  CHECK(files.size() > 6);
}

}  // namespace twinray::test

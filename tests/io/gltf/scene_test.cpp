// SPDX-License-Identifier: Apache-2.0
// Cameras and lights of glTF files, their two forms, and what is wrong with others.
#include "io/gltf/gltf.h"

#include "core/elementary.h"
#include "io/scene_file.h"
#include "tests/io/gltf/file.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace twinray {
namespace {

using nlohmann::json;
using test::gltf_triangle;
using test::GltfFile;

GltfFile with_camera(const json& camera) {
  GltfFile file = gltf_triangle();
  file.add_node({{"camera", file.add("cameras", camera)}, {"translation", {0, 0, 5}}, {"name", "stand"}});
  return file;
}

GltfFile with_light(const json& light) {
  GltfFile file = gltf_triangle();
  file.json["extensions"]["KHR_lights_punctual"]["lights"] = json::array({light});
  file.add_node({{"translation", {0, 4, 0}},
                 {"scale", {2, 2, 2}},
                 {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  return file;
}

template <typename Source>
Source light_of(const GltfFile& file) {
  return std::get<Source>(file.load().scene.lights.at(0).source);
}

}  // namespace

TEST_CASE("gltf: a camera keeps its height whatever the picture's shape") {
  const GltfFile file = with_camera({{"type", "perspective"},
                                     {"name", "front"},
                                     {"perspective", {{"yfov", 1.0}, {"aspectRatio", 3}, {"znear", 0.1}}}});
  const LoadedScene loaded = file.load();
  CHECK(loaded.summary.camera == "front");
  const Camera& camera = loaded.scene.camera;
  CHECK(camera.position == Vec3{0, 0, 5});
  CHECK(camera.forward == Vec3{0, 0, -1});
  CHECK(camera.clip_near == 0);
  for (const auto& [width, height] : {std::pair{400, 100}, {100, 400}})
    CHECK(fit_frame(camera, width, height).tan_half_height == Approx(tan_radians(0.5)));
  CHECK(file.load({.clip_as_file = true}).scene.camera.clip_near == 0.1f);
}

TEST_CASE("gltf: an orthographic camera has half its frame in scene units, whatever the scale of its node") {
  GltfFile file = with_camera(
      {{"type", "orthographic"}, {"orthographic", {{"xmag", 2}, {"ymag", 1}, {"zfar", 9}, {"znear", 0}}}});
  file.json["nodes"][1]["scale"] = {3, 3, 3};
  const Camera camera = file.load().scene.camera;
  CHECK(camera.projection == Projection::orthographic);
  CHECK(camera.tan_half_width == 2);
  CHECK(camera.tan_half_height == 1);
  CHECK(file.load().summary.camera == "stand");
}

TEST_CASE("gltf: a camera is chosen by its name or its node's") {
  GltfFile file = with_camera({{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}});
  file.add("cameras",
           {{"type", "perspective"}, {"name", "back"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}});
  file.add_node({{"camera", 1}, {"translation", {0, 0, -5}}});
  CHECK(file.load().scene.camera.position.z == 5);
  CHECK(file.load({.camera_name = "back"}).scene.camera.position.z == -5);
  CHECK(file.load({.camera_name = "stand"}).scene.camera.position.z == 5);
  CHECK(file.load().summary.cameras == std::vector<std::string>{"stand", "back"});
  CHECK(file.error({.camera_name = "top"}) ==
        "test.gltf: no camera, and no node of one, has the name \"top\"; the scene has \"stand\", \"back\"");
}

TEST_CASE("gltf: candela are intensity and lux irradiance, whatever the node's scale") {
  const json color{0.5, 1, 0};
  const auto point =
      light_of<PointLight>(with_light({{"type", "point"}, {"color", color}, {"intensity", 8}}));
  CHECK(point.intensity == Rgb{4, 8, 0});
  CHECK(point.position == Vec3{0, 4, 0});
  CHECK(point.attenuation.quadratic == 1);
  const auto sun = light_of<DirectionalLight>(with_light({{"type", "directional"}, {"intensity", 3}}));
  CHECK(sun.irradiance == Rgb{3, 3, 3});
  CHECK(sun.direction == Vec3{0, 0, -1});
  const auto spot = light_of<SpotLight>(
      with_light({{"type", "spot"}, {"spot", {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.5}}}}));
  CHECK(spot.intensity == Rgb{1, 1, 1});
  CHECK(spot.direction == Vec3{0, 0, -1});
  CHECK(spot.falloff_angle_degrees == Approx(57.29578));
  CHECK(spot.penumbra_degrees == Approx(14.323945));
}

TEST_CASE("gltf: a range ends the light of a point or a spot, but for a sun it means nothing") {
  CHECK(with_light({{"type", "directional"}, {"range", 3}}).load().warnings.empty());
  CHECK(with_light({{"type", "point"}, {"range", 3}}).warning() ==
        "test.gltf: /extensions/KHR_lights_punctual/lights/0/range: light without an end is rendered: a "
        "range is "
        "left out");
}

TEST_CASE("gltf: a camera without what its type asks for is an error with its place") {
  CHECK(with_camera({{"type", "perspective"}}).error() ==
        "test.gltf: /cameras/0: \"perspective\" is missing, and required of such a camera");
  CHECK(with_camera({{"type", "orthographic"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}}).error() ==
        "test.gltf: /cameras/0: \"orthographic\" is missing, and required of such a camera");
}

TEST_CASE("gltf: a spot light that says no angles has those of the extension, and is named") {
  const GltfFile file = with_light({{"type", "spot"}});
  CHECK(file.warning() ==
        "test.gltf: /extensions/KHR_lights_punctual/lights/0: a spot light needs \"spot\"; without one its "
        "angles are 0 and 45 degrees");
  const auto spot = light_of<SpotLight>(file);
  CHECK(spot.falloff_angle_degrees == Approx(90));
  CHECK(spot.penumbra_degrees == Approx(45));
}

TEST_CASE("gltf: a light whose node is shrunk to nothing is left out, but for one that needs no direction") {
  for (const char* type : {"point", "directional", "spot"}) {
    GltfFile file = with_light({{"type", type}, {"spot", {{"outerConeAngle", 0.5}}}});
    file.json["nodes"][1]["scale"] = {0, 0, 0};
    const LoadedScene loaded = file.load();
    const bool is_point = std::string(type) == "point";
    CHECK(loaded.scene.lights.size() == (is_point ? 1 : 0));
    CHECK(loaded.warnings.size() == (is_point ? 0 : 1));
  }
}

TEST_CASE("gltf: lights that are no lights are errors with their place") {
  CHECK(with_light({{"type", "spot"}, {"spot", {{"innerConeAngle", 1}, {"outerConeAngle", 0.5}}}})
            .error()
            .find("test.gltf: /extensions/KHR_lights_punctual/lights/0/spot: innerConeAngle is 1 and") == 0);
  CHECK(with_light({{"type", "tube"}}).error() ==
        "test.gltf: /extensions/KHR_lights_punctual/lights/0/type: this is \"tube\"; valid is directional, "
        "point or spot");
  GltfFile file = with_light({{"type", "point"}});
  file.json["nodes"][1]["extensions"]["KHR_lights_punctual"]["light"] = 1;
  CHECK(
      file.error() ==
      "test.gltf: /nodes/1/extensions/KHR_lights_punctual/light: the index 1 is out of range; the file has 1 "
      "lights");
}

TEST_CASE("gltf: a node that is not visible hides its mesh, its light and what is below it, but no camera") {
  GltfFile file = with_light({{"type", "point"}});
  file.json["extensionsUsed"] = {"KHR_node_visibility"};
  const int camera =
      file.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}});
  file.json["nodes"][1]["mesh"] = 0;
  file.json["nodes"][1]["children"] = {file.add("nodes", {{"mesh", 0}, {"camera", camera}})};
  const auto shown = [&] {
    const LoadedScene loaded = file.load();
    CHECK(loaded.warnings.empty());
    CHECK(loaded.summary.cameras.size() == 1);
    return std::pair{loaded.scene.geometry->shapes().size(), loaded.scene.lights.size()};
  };
  json& visibility = file.json["nodes"][1]["extensions"]["KHR_node_visibility"];
  visibility = json::object();
  CHECK(shown() == std::pair<std::size_t, std::size_t>(3, 1));
  visibility["visible"] = false;
  CHECK(shown() == std::pair<std::size_t, std::size_t>(1, 0));
  file.json["nodes"][2]["extensions"]["KHR_node_visibility"]["visible"] = true;
  CHECK(shown() == std::pair<std::size_t, std::size_t>(1, 0));
  visibility["visible"] = true;
  file.json["nodes"][2]["extensions"]["KHR_node_visibility"]["visible"] = false;
  CHECK(shown() == std::pair<std::size_t, std::size_t>(2, 1));
  visibility["visible"] = 1;
  CHECK(file.error() ==
        "test.gltf: /nodes/1/extensions/KHR_node_visibility/visible: this is 1; valid is true or "
        "false");
}

TEST_CASE("gltf: buffers lie beside the file, and what they lack is said") {
  const test::TemporaryFolder folder;
  GltfFile file = gltf_triangle();
  json whole = file.json;
  whole["buffers"] = {{{"byteLength", file.buffer.size()}, {"uri", "data.bin"}}};
  const std::string path = folder.file("scene.gltf");
  test::write_text(path, whole.dump());
  const auto error = [&]() -> std::string {
    try {
      load_scene(path);
    } catch (const Error& failed) {
      return failed.what();
    }
    return "";
  };
  CHECK(error() == path + ": /buffers/0/uri: " + folder.file("data.bin") + ": there is no such file");
  test::write_text(folder.file("data.bin"), file.buffer.substr(1));
  CHECK(error() == path + ": /buffers/0: the buffer has 35 bytes, and its byteLength is 36");
  test::write_text(folder.file("data.bin"), file.buffer);
  CHECK(error().empty());
  CHECK(load_scene(path).summary.triangles == 1);
}

TEST_CASE("gltf: each fault of the text is an error with its pointer and what is valid") {
  struct Fault {
    const char *pointer, *value, *message;
  };
  const Fault faults[] = {
      {"/asset/version", "\"1.0\"", "/asset/version: the version of glTF is \"1.0\"; valid is 2.0"},
      {"/asset", "3", "/asset: this is 3; valid is an object"},
      {"/asset/minVersion", "\"2.1\"",
       "/asset/minVersion: the file asks for version \"2.1\"; what is read is 2.0"},
      {"/nodes/0", R"({"mesh": 0, "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1], "translation": [0,0,1]})",
       "/nodes/0: a node has a matrix, or a translation, rotation and scale; not both"},
      {"/nodes/0", R"({"mesh": 0, "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1], "rotation": [0,0,0,1]})",
       "/nodes/0: a node has a matrix, or a translation, rotation and scale; not both"},
      {"/nodes/0", R"({"mesh": 0, "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1], "scale": [1,2,1]})",
       "/nodes/0: a node has a matrix, or a translation, rotation and scale; not both"},
      {"/accessors/0/count", "-1",
       "/accessors/0/count: this is -1; valid is a whole number from 1 to 4294967295"},
      {"/accessors/0/count", "4000000000",
       "/accessors/0: 4000000000 elements of 12 bytes, 12 apart, from byte 0 on reach beyond the 36 bytes of "
       "/bufferViews/0"},
      {"/accessors/0/count", "1.5",
       "/accessors/0/count: this is 1.5; valid is a whole number from 1 to 4294967295"},
      {"/accessors/0/componentType", "5124",
       "/accessors/0/componentType: this is 5124; valid is 5120, 5121, 5122, 5123, 5125 or 5126"},
      {"/accessors/0/type", "\"VEC2\"",
       "/accessors/0: the type is VEC2; what names this accessor takes VEC3"},
      {"/accessors/0/type", "\"VEC5\"",
       "/accessors/0/type: this is \"VEC5\"; valid is SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3 or MAT4"},
      {"/accessors/0/bufferView", "7",
       "/accessors/0/bufferView: this is 7; valid is a whole number from 0 to 0"},
      {"/bufferViews/0/byteLength", "100",
       "/bufferViews/0: bytes 0 to 100 are asked for, and the buffer 0 has 36"},
      {"/bufferViews/0/byteStride", "18",
       "/bufferViews/0/byteStride: this is 18; valid is a multiple of 4 from 4 to 252"},
      {"/images/0", R"({"uri": "a.png", "bufferView": 0})",
       "/images/0: an image has its \"uri\" or its \"bufferView\"; not both"},
      {"/bufferViews/0/byteOffset", "40",
       "/bufferViews/0: bytes 40 to 76 are asked for, and the buffer 0 has 36"},
      {"/buffers/0/byteLength", "1e15",
       "/buffers/0: the buffer has 36 bytes, and its byteLength is 1000000000000000"},
      {"/buffers/0/uri", "\"http://x/y.bin\"",
       "/buffers/0/uri: \"http://x/y.bin\" lies on another machine; files of this one are read"},
      {"/buffers/0/uri", "\"data:;base64,A?==\"",
       "/buffers/0/uri: the data URI holds a character that is none of base64's"},
      {"/meshes/0/primitives", "[]", "/meshes/0/primitives: 0 elements; valid are 1 and more"},
      {"/meshes/0/primitives/0/mode", "7",
       "/meshes/0/primitives/0/mode: this is 7; valid is 0, 1, 2, 3, 4, 5 or 6"},
      {"/meshes/0/primitives/0/material", "0",
       "/meshes/0/primitives/0/material: this is 0; valid is none: the file has no materials"},
      {"/nodes/0/children", "[0]", "/nodes/0: the node is its own ancestor; nodes form trees"},
      {"/nodes/0/children", "[]", ""},
      {"/nodes/0/scale", "[1,2]", "/nodes/0/scale: 2 numbers; valid are 3"},
      {"/nodes/0/matrix", "[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,2]",
       "/nodes/0/matrix: the last row is 0 0 0 2; it must be 0 0 0 1"},
      {"/nodes/0/translation", "[0,0,1e20]",
       "/meshes/0/primitives/0: a vertex of \"mesh 0\" comes to (0, 0, 1e+20); coordinates must lie within "
       "+-1e+12"},
      {"/scenes/0/nodes", "[0,0]", "/scenes/0/nodes/1: the index 0 stands here a second time"},
      {"/nodes/0/name", "[]", "/nodes/0/name: this is array; valid is text"},
  };
  for (const Fault& fault : faults) {
    INFO(fault.pointer << " = " << fault.value);
    json whole = json::parse(gltf_triangle().text());
    whole[json::json_pointer(fault.pointer)] = json::parse(fault.value);
    std::string message;
    try {
      read_gltf(whole.dump(), "test.gltf");
    } catch (const Error& error) {
      message = error.what();
    }
    CHECK(message == (*fault.message ? std::string("test.gltf: ") + fault.message : ""));
  }
}

TEST_CASE("gltf: indices beyond the positions, and attributes of other counts, are errors") {
  GltfFile file = gltf_triangle();
  file.primitive()["indices"] = file.accessor<std::uint16_t>({0, 1, 3}, "SCALAR");
  CHECK(
      file.error() ==
      "test.gltf: /meshes/0/primitives/0/indices: the index 3 (number 2) is out of range; valid are 0 to 2");
  file = gltf_triangle();
  file.primitive()["attributes"]["NORMAL"] = file.accessor<float>({0, 0, 1}, "VEC3");
  CHECK(
      file.error() ==
      "test.gltf: /meshes/0/primitives/0/attributes/NORMAL: 1 values for 3 positions; there must be as many");
}

TEST_CASE("gltf: a small file that says it is large takes no memory") {
  GltfFile file = gltf_triangle();
  file.json["accessors"][0].erase("bufferView");
  file.json["accessors"][0]["count"] = 4000000000u;
  const std::string refused = "/accessors/0/count: 4000000000 zeros without a buffer view; at most ";
  CHECK(file.error().starts_with("test.gltf: " + refused));
  const std::string promise =
      R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":90000000000}],"scenes":[{"nodes":[0]}],)"
      R"("accessors":[{"componentType":5126,"count":4000000000,"type":"VEC3"}],"nodes":[{"mesh":0}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}]})";
  CHECK(test::glb_error(promise).starts_with("test.glb: " + refused));
}

TEST_CASE("gltf: the last element of an accessor ends with its view") {
  GltfFile file = gltf_triangle();
  file.json["bufferViews"][0]["byteStride"] = 12;
  CHECK(file.error().empty());
  file.json["accessors"][0]["byteOffset"] = 1;
  CHECK(file.error() ==
        "test.gltf: /accessors/0: 3 elements of 12 bytes, 12 apart, from byte 1 on reach beyond the 36 bytes "
        "of "
        "/bufferViews/0");
}

TEST_CASE("gltf: elements that would overlap are refused") {
  GltfFile file = gltf_triangle();
  file.json["bufferViews"][0]["byteStride"] = 8;
  CHECK(file.error() ==
        "test.gltf: /bufferViews/0/byteStride: is 8, and /accessors/0 has elements of 12 bytes");
}

TEST_CASE("gltf: text that is no JSON is an error with its line, and so is deep nesting") {
  const auto error = [](const std::string& text) { return test::glb_error(text); };
  CHECK(error("{\"asset\":\n  {\"version\": }}").find("test.glb:2:15: the text is not JSON here") == 0);
  CHECK(error(std::string(100000, '[')).find("nest deeper than 100 levels") != std::string::npos);
  CHECK(error("{\"asset\": {\"version\": \"2.0\"}, \"scene\": 1e999}").find("too large") !=
        std::string::npos);
  CHECK(error("{\"asset\": {\"version\": \"2.0 1e999\"},\n \"scene\": [1, 2e-9, -1e999]}")
            .find("test.glb:2:21: the JSON text holds a number that is too large\n") == 0);
  CHECK(error("[]") == "test.glb: /: a glTF file is one JSON object");
  CHECK(error("{}") == "test.glb: /: \"asset\" is missing, and required");
}

TEST_CASE("gltf: a file of version 1 is called that, whatever its shape") {
  const std::string lists = R"("accessors": {"a": {}}, "nodes": {"n": {}}, "meshes": {}})";
  const std::string old = "test.glb: /asset/version: the version of glTF is \"1.0\"; valid is 2.0";
  CHECK(test::glb_error(R"({"asset": {"version": "1.0", "premultipliedAlpha": true}, )" + lists) == old);
  CHECK(test::glb_error(R"({"asset": {"version": 1}, )" + lists) == old);
  CHECK(test::glb_error(R"({"asset": {"version": 1.0}, )" + lists) == old);
  CHECK(test::glb_error("{" + lists) ==
        "test.glb: /nodes: this is an object, as in glTF 1.0; valid is an array, as in glTF 2.0");
  CHECK(test::glb_error(R"({"asset": {"version": 2}})") ==
        "test.glb: /asset/version: this is 2; valid is text");
  CHECK(test::glb_error(R"({"asset": {"version": null}})") ==
        "test.glb: /asset/version: this is null; valid is text");
}

TEST_CASE("gltf: names that are not known are warned of, with the nearest one") {
  GltfFile file = gltf_triangle();
  file.json["nodes"][0]["tranlation"] = {1, 2, 3};
  CHECK(file.warning() ==
        "test.gltf: /nodes/0: \"tranlation\" is not a known name; did you mean \"translation\"?");
}

TEST_CASE("gltf: nodes with two parents are no tree") {
  GltfFile file = gltf_triangle();
  file.add_node({{"children", {0}}});
  CHECK(file.error() ==
        "test.gltf: /scenes/0/nodes: node 0 is a child of node 1; a scene names nodes without a parent");
  file.add_node({{"children", {0}}});
  CHECK(file.error() ==
        "test.gltf: /nodes/0: the node is a child of both node 1 and node 2; nodes form trees");
}

TEST_CASE("gltf: triangles that are not finite are dropped and counted") {
  GltfFile file;
  const float inf = std::numeric_limits<float>::infinity();
  const int positions =
      file.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, inf, 0, 0, 0, 1, 0}, "VEC3");
  file.show({{"attributes", {{"POSITION", positions}}}});
  CHECK(file.load().summary.dropped_triangles == 1);
  CHECK(file.load().summary.triangles == 1);
}

}  // namespace twinray

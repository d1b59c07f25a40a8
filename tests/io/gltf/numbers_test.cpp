// SPDX-License-Identifier: Apache-2.0
// What accessors of glTF files may hold: by their use, finite, aligned, and what no rotation or weight is.
#include <cmath>
#include <limits>

#include "tests/io/gltf/file.h"
#include "tests/support/catch.h"

namespace twinray {
namespace {

using nlohmann::json;
using test::gltf_triangle;
using test::GltfFile;
using test::only_mesh;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();

std::string place_of(int accessor) { return "test.gltf: /accessors/" + std::to_string(accessor); }

/// What a triangle fails with whose attribute has so many numbers of this type a vertex, all of them 0.
template <typename Number>
std::string error_of(const char* name, const char* type, bool is_normalized = false,
                     bool is_quantized = false) {
  GltfFile file = gltf_triangle();
  const std::size_t components = std::size_t(type[3] - '0');
  std::vector<Number> numbers(4 * 4, Number(0));
  const int accessor = file.accessor<Number>(numbers, type, is_normalized);
  auto& described = file.json["accessors"][std::size_t(accessor)];
  described["count"] = 3;
  const std::size_t stride = (components * sizeof(Number) + 3) / 4 * 4;
  file.json["bufferViews"][described["bufferView"].get<std::size_t>()]["byteStride"] = stride;
  if (is_quantized) file.json["extensionsUsed"] = {"KHR_mesh_quantization"};
  file.primitive()["attributes"][name] = accessor;
  const std::string error = file.error(), place = place_of(accessor) + "/componentType: ";
  return error.starts_with(place) ? error.substr(place.size()) : error;
}

/// The triangle with one joint, whose weights these are.
GltfFile skinned(const std::vector<float>& weights) {
  GltfFile file = gltf_triangle();
  auto& attributes = file.primitive()["attributes"];
  attributes["JOINTS_0"] = file.accessor<std::uint8_t>(std::vector<std::uint8_t>(12, 0), "VEC4");
  attributes["WEIGHTS_0"] = file.accessor<float>(weights, "VEC4");
  file.json["skins"] = {{{"joints", {1}}}};
  file.json["nodes"][0]["skin"] = 0;
  file.add_node({{"translation", {0, 0, 5}}});
  return file;
}

GltfFile bound_by(std::vector<float> matrix) {
  GltfFile file = skinned({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  file.json["skins"][0]["inverseBindMatrices"] = file.accessor<float>(matrix, "MAT4");
  return file;
}

/// A triangle that moves from 0 to 1 seconds.
template <typename Number>
GltfFile moved(const char* path, const std::vector<Number>& values, const char* type,
               bool is_normalized = false) {
  GltfFile file = gltf_triangle();
  const int times = file.accessor<float>({0, 1}, "SCALAR");
  const int output = file.accessor<Number>(values, type, is_normalized);
  file.json["animations"] = {{{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}},
                              {"samplers", {{{"input", times}, {"output", output}}}}}};
  return file;
}

std::string warning_at(const GltfFile& file, double time) {
  const auto warnings = file.load({.time = time}).warnings;
  return warnings.size() == 1 ? warnings[0].text() : "";
}

}  // namespace

TEST_CASE("gltf: attributes have the numbers that the format says, and what quantization adds") {
  CHECK(error_of<float>("NORMAL", "VEC3").empty());
  CHECK(error_of<std::int16_t>("POSITION", "VEC3") ==
        "this is 5122; valid for POSITION is 5126; with KHR_mesh_quantization also 5120, 5120 normalized, "
        "5121, "
        "5121 normalized, 5122, 5122 normalized, 5123 and 5123 normalized");
  CHECK(error_of<std::int16_t>("POSITION", "VEC3", false, true).empty());
  CHECK(error_of<std::int8_t>("NORMAL", "VEC3", true, true).empty());
  CHECK(error_of<std::int8_t>("NORMAL", "VEC3", false, true) ==
        "this is 5120; valid for NORMAL is 5126, and 5120 normalized and 5122 normalized");
  CHECK(error_of<std::int16_t>("TANGENT", "VEC4", true, true).empty());
  CHECK(error_of<std::uint8_t>("TEXCOORD_0", "VEC2", true).empty());
  CHECK(error_of<std::uint8_t>("TEXCOORD_0", "VEC2", false, true).empty());
  CHECK(error_of<std::uint8_t>("TEXCOORD_1", "VEC2") ==
        "this is 5121; valid for TEXCOORD_n are 5126, 5121 normalized and 5123 normalized; with "
        "KHR_mesh_quantization also 5120, 5120 normalized, 5121, 5122, 5122 normalized and 5123");
  CHECK(error_of<std::uint16_t>("COLOR_0", "VEC4", true).empty());
  CHECK(error_of<std::uint8_t>("COLOR_0", "VEC3", false, true) ==
        "this is 5121; valid for COLOR_n are 5126, 5121 normalized and 5123 normalized");
  CHECK(error_of<std::int8_t>("COLOR_0", "VEC3", true, true) ==
        "this is 5120 normalized; valid for COLOR_n are 5126, 5121 normalized and 5123 normalized");
}

TEST_CASE("gltf: joints are whole numbers, and weights are parts of 1") {
  const std::vector<float> whole{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  GltfFile file = skinned(whole);
  CHECK(file.load().warnings.empty());
  const int joints = file.primitive()["attributes"]["JOINTS_0"];
  file.json["accessors"][std::size_t(joints)]["normalized"] = true;
  CHECK(file.error() ==
        place_of(joints) + "/componentType: this is 5121 normalized; valid for JOINTS_n are 5121 and 5123");
  file = skinned(whole);
  const int weights = file.accessor<std::uint8_t>({255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0}, "VEC4");
  file.primitive()["attributes"]["WEIGHTS_0"] = weights;
  CHECK(file.error() == place_of(weights) +
                            "/componentType: this is 5121; valid for WEIGHTS_n are 5126, 5121 "
                            "normalized and 5123 normalized");
  file.json["accessors"][std::size_t(weights)]["normalized"] = true;
  CHECK(file.load().warnings.empty());
  file = bound_by(std::vector<float>(16, 0));
  const int matrices = file.json["skins"][0]["inverseBindMatrices"];
  file.json["accessors"][std::size_t(matrices)]["componentType"] = 5125;
  CHECK(file.error() ==
        place_of(matrices) + "/componentType: this is 5125; valid for inverse bind matrices is 5126");
}

TEST_CASE("gltf: times and what they move have the numbers that the format says") {
  CHECK(moved<std::int16_t>("rotation", {0, 0, 0, 1, 0, 0, 0, 1}, "VEC4").error({.time = 0}) ==
        "test.gltf: /accessors/2/componentType: this is 5122; valid for rotations of an animation are 5126, "
        "5120 "
        "normalized, 5121 normalized, 5122 normalized and 5123 normalized");
  CHECK(moved<std::int16_t>("rotation", {0, 0, 0, 1, 0, 0, 0, 1}, "VEC4", true).error({.time = 0}).empty());
  CHECK(moved<std::int16_t>("translation", {0, 0, 0, 1, 0, 0}, "VEC3", true).error({.time = 0}) ==
        "test.gltf: /accessors/2/componentType: this is 5122 normalized; valid for translations of an "
        "animation "
        "is 5126");
  CHECK(moved<std::uint8_t>("scale", {1, 1, 1, 1, 1, 1}, "VEC3").error({.time = 0}) ==
        "test.gltf: /accessors/2/componentType: this is 5121; valid for scales of an animation is 5126");
  GltfFile file = moved<float>("scale", {1, 1, 1, 1, 1, 1}, "VEC3");
  file.json["accessors"][1]["componentType"] = 5125;
  CHECK(file.error() ==
        "test.gltf: /accessors/1/componentType: this is 5125; valid for times of an animation is 5126");
}

TEST_CASE("gltf: morph targets and instances have the numbers that the format says") {
  GltfFile file = gltf_triangle();
  const int moves = file.accessor<std::uint32_t>(std::vector<std::uint32_t>(9, 0), "VEC3");
  file.primitive()["targets"] = {{{"POSITION", moves}}};
  file.json["meshes"][0]["weights"] = {1};
  CHECK(file.error() ==
        "test.gltf: /accessors/1/componentType: this is 5125; valid for POSITION of a morph target is 5126; "
        "with "
        "KHR_mesh_quantization also 5120, 5120 normalized, 5122 and 5122 normalized");
  file = gltf_triangle();
  auto& attributes = file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
  attributes["ROTATION"] = file.accessor<std::int16_t>({0, 0, 0, 32767}, "VEC4", true);
  CHECK(file.load().warnings.empty());
  attributes["SCALE"] = file.accessor<std::uint32_t>({1, 1, 1}, "VEC3");
  CHECK(file.error() ==
        "test.gltf: /accessors/2/componentType: this is 5125; valid for SCALE of instances is 5126");
}

TEST_CASE("gltf: numbers that must be finite and are not are named with their element") {
  GltfFile file = gltf_triangle();
  file.primitive()["attributes"]["COLOR_0"] = file.accessor<float>({1, 1, 1, 1, nan, 1, 1, 1, 1}, "VEC3");
  CHECK(file.error() == "test.gltf: /accessors/1: element 1 holds nan; COLOR_n must be finite");
  CHECK(skinned({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, inf, 0}).error() ==
        "test.gltf: /accessors/2: element 2 holds inf; WEIGHTS_n must be finite");
  file = moved<float>("translation", {0, 0, 0, 0, -inf, 0}, "VEC3");
  CHECK(file.error({.time = 0}) ==
        "test.gltf: /accessors/2: element 1 holds -inf; translations of an animation must be finite");
  CHECK(bound_by({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, nan, 0, 0, 1}).error() ==
        "test.gltf: /accessors/3: element 0 holds nan; inverse bind matrices must be finite");
}

TEST_CASE("gltf: the last row of an inverse bind matrix is 0 0 0 1, but for rounding") {
  CHECK(bound_by({1, 0, 0, 0.5f, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2}).error() ==
        "test.gltf: /accessors/3: matrix 0: the last row is 0.5 0 0 2; it must be 0 0 0 1");
  CHECK(bound_by({1, 0, 0, 1e-8f, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0.9999999f}).error().empty());
}

TEST_CASE("gltf: weights below 0, or that do not add up to 1, are counted, and what is done is said") {
  const std::string warning =
      "test.gltf: /meshes/0/primitives/0/attributes/WEIGHTS_0: a vertex has weights below 0, or that do not "
      "add "
      "up to 1: those above 0 count, divided by their sum; without any the vertex stays where it is";
  CHECK(skinned({0.995f, 0, 0, 0, 1.015f, 0, 0, 0, 0.5f, 0.5f, 0, 0}).load().warnings.empty());
  GltfFile file = skinned({0.1f, 0, 0, 0, 1.5f, -0.5f, 0, 0, 0, 0, 0, 0});
  CHECK(file.warning() == warning + " (3 times)");
  const LoadedScene loaded = file.load();
  const Mesh& mesh = only_mesh(loaded);
  CHECK(mesh.positions == std::vector<Vec3>{{0, 0, 5}, {1, 0, 5}, {0, 1, 0}});
  CHECK(skinned({1, 0, 0, 0, 1, 0, 0, 0, 0.9f, 0, 0, 0}).warning() == warning);
}

TEST_CASE("gltf: 0 0 0 0 is no rotation, of a node, an instance or at a time") {
  const std::string fault = ": 0 0 0 0 is no rotation: nothing is turned by it";
  GltfFile file = gltf_triangle();
  file.json["nodes"][0]["rotation"] = {0, 0, 0, 0};
  CHECK(file.warning() == "test.gltf: /nodes/0/rotation" + fault);
  CHECK(only_mesh(file.load()).positions[1] == Vec3{1, 0, 0});
  file = moved<float>("rotation", {0, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
  CHECK(warning_at(file, 0) == "test.gltf: /animations/0/samplers/0/output" + fault + " (2 times)");
  file = gltf_triangle();
  file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["ROTATION"] =
      file.accessor<float>({0, 0, 0, 0}, "VEC4");
  CHECK(file.warning() ==
        "test.gltf: /nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/ROTATION" + fault);
}

TEST_CASE("gltf: the largest number of its type is no index") {
  const auto fault = [](const char* index, const char* most) {
    return "test.gltf: /meshes/0/primitives/0/indices: the index " + std::string(index) +
           " (number 2) is the largest of its type, which names no vertex (elsewhere it restarts a strip); "
           "valid "
           "are 0 to " +
           most;
  };
  GltfFile file = gltf_triangle();
  file.primitive()["indices"] = file.accessor<std::uint16_t>({0, 1, 65535}, "SCALAR");
  CHECK(file.error() == fault("65535", "2"));
  // Even where there is such a vertex.
  GltfFile large;
  const int positions = large.accessor<float>(std::vector<float>(256 * 3, 0.0f), "VEC3");
  const int indices = large.accessor<std::uint8_t>({0, 254, 255}, "SCALAR");
  large.show({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
  CHECK(large.error() == fault("255", "254"));
}

TEST_CASE("gltf: numbers begin at multiples of their size") {
  GltfFile file = gltf_triangle();
  file.buffer += std::string(4, '\0');
  file.json["bufferViews"][0]["byteOffset"] = 2;
  const std::string message =
      "test.gltf: /accessors/0: the numbers begin at byte 2 of the buffer (with the byteOffset of "
      "/bufferViews/0); it must be a multiple of their 4 bytes";
  CHECK(file.error() == message);
  file.json["bufferViews"][0]["byteOffset"] = 0;
  file.json["bufferViews"][0]["byteLength"] = 40;
  file.json["accessors"][0]["byteOffset"] = 2;
  CHECK(file.error() == message);
  file.json["bufferViews"][0]["byteOffset"] = 2;
  file.json["bufferViews"][0]["byteLength"] = 38;
  CHECK(file.error().empty());
  file.json["accessors"][0]["byteOffset"] = 0;
  file.json["bufferViews"][0]["byteOffset"] = 4;
  file.json["bufferViews"][0]["byteLength"] = 36;
  CHECK(file.error().empty());
}

}  // namespace twinray

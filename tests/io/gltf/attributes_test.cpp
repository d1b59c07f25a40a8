// SPDX-License-Identifier: Apache-2.0
// Names of attributes in glTF files, and how many of them there must be.
#include "tests/io/gltf/file.h"
#include "tests/support/catch.h"

namespace twinray {
namespace {

using nlohmann::json;
using test::gltf_triangle;
using test::GltfFile;

/// A triangle with so many morph targets, each of which moves no vertex.
GltfFile with_targets(std::size_t count) {
  GltfFile file = gltf_triangle();
  const int still = file.accessor<float>(std::vector<float>(9, 0.0f), "VEC3");
  for (std::size_t i = 0; i < count; ++i) file.primitive()["targets"].push_back({{"POSITION", still}});
  return file;
}

std::string warning_of_attribute(const char* name) {
  GltfFile file = gltf_triangle();
  file.primitive()["attributes"][name] = 0;
  const std::string start = "test.gltf: /meshes/0/primitives/0/attributes/" + std::string(name) + ": ";
  const std::string warning = file.warning();
  return warning.starts_with(start) ? warning.substr(start.size()) : warning;
}

}  // namespace

TEST_CASE("gltf: attributes that the format does not know are named, with the nearest") {
  CHECK(warning_of_attribute("NORMALS") == "\"NORMALS\" is not a known attribute; did you mean \"NORMAL\"?");
  CHECK(warning_of_attribute("COLOR1") == "\"COLOR1\" is not a known attribute; did you mean \"COLOR_1\"?");
  CHECK(warning_of_attribute("color_0") == "\"color_0\" is not a known attribute; did you mean \"COLOR_0\"?");
  CHECK(warning_of_attribute("TEXCOORD_01") ==
        "\"TEXCOORD_01\" is not a known attribute; did you mean \"TEXCOORD_1\"?");
  CHECK(warning_of_attribute("TEXCOORD_") ==
        "\"TEXCOORD_\" is not a known attribute; did you mean \"TEXCOORD_0\"?");
  CHECK(warning_of_attribute("temperature") == "\"temperature\" is not a known attribute");
  for (const char* name : {"_TEMPERATURE", "TEXCOORD_12", "COLOR_3"}) {
    GltfFile file = gltf_triangle();
    const int uvs = file.accessor<float>({0, 0, 0, 0, 0, 0}, "VEC2");
    file.primitive()["attributes"][name] = uvs;
    CHECK(file.load().warnings.empty());
  }
}

TEST_CASE("gltf: attributes of morph targets are named whatever their weight, and those of instances, too") {
  GltfFile file = with_targets(1);
  file.primitive()["targets"][0]["NORMALS"] = 0;
  CHECK(file.warning() ==
        "test.gltf: /meshes/0/primitives/0/targets/0/NORMALS: \"NORMALS\" is not a known attribute; did you "
        "mean \"NORMAL\"?");
  file = gltf_triangle();
  const int places = file.accessor<float>({0, 0, 1}, "VEC3");
  file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
      {"TRANSLATION", places}, {"SCALES", places}, {"_ID", places}};
  CHECK(file.warning() ==
        "test.gltf: /nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/SCALES: \"SCALES\" is not a known "
        "attribute; did you mean \"SCALE\"?");
}

TEST_CASE("gltf: joints and weights come together, in sets from 0 on") {
  GltfFile file = gltf_triangle();
  const std::string place = "test.gltf: /meshes/0/primitives/0/attributes/";
  json& attributes = file.primitive()["attributes"];
  const int joints = file.accessor<std::uint8_t>(std::vector<std::uint8_t>(12, 0), "VEC4");
  attributes["JOINTS_0"] = joints;
  CHECK(file.error() == place + "JOINTS_0: JOINTS_0 is here, and WEIGHTS_0, which it needs, is not");
  attributes.erase("JOINTS_0");
  const int weights = file.accessor<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
  attributes["WEIGHTS_0"] = weights;
  CHECK(file.error() == place + "WEIGHTS_0: WEIGHTS_0 is here, and JOINTS_0, which it needs, is not");
  attributes.erase("WEIGHTS_0");
  attributes["JOINTS_1"] = joints, attributes["WEIGHTS_1"] = weights;
  CHECK(file.error() == place + "JOINTS_1: JOINTS_1 is here, and JOINTS_0, which it needs, is not");
  attributes["JOINTS_0"] = joints, attributes["WEIGHTS_0"] = weights;
  CHECK(file.error().empty());
}

TEST_CASE("gltf: there are as many weights as morph targets, and as many of these in all primitives") {
  GltfFile file = with_targets(2);
  file.json["meshes"][0]["weights"] = {1};
  CHECK(file.error() == "test.gltf: /meshes/0/weights: 1 weights for 2 morph targets; there must be as many");
  file.json["meshes"][0]["weights"] = {1, 0};
  file.json["nodes"][0]["weights"] = {0, 0, 1};
  CHECK(file.error() == "test.gltf: /nodes/0/weights: 3 weights for 2 morph targets; there must be as many");
  file.json["nodes"][0]["weights"] = json::array();
  CHECK(file.error().empty());
  json other = file.primitive();
  other["targets"].erase(1);
  file.json["meshes"][0]["primitives"].push_back(other);
  CHECK(
      file.error() ==
      "test.gltf: /meshes/0/primitives/1: 1 morph targets, and primitive 0 has 2; all of a mesh must have as "
      "many");
  file = gltf_triangle();
  file.json["meshes"][0]["weights"] = {1};
  CHECK(file.error() == "test.gltf: /meshes/0/weights: 1 weights for 0 morph targets; there must be as many");
  file = gltf_triangle();
  file.add_node({{"weights", {1}}});
  CHECK(file.warning() == "test.gltf: /nodes/1/weights: weights of a node without a mesh have no effect");
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// What moves in glTF files: morph targets, skins and animations.
#include "io/gltf/animation.h"

#include "io/gltf/curve.h"
#include "tests/io/gltf/file.h"
#include "tests/support/catch.h"

namespace twinray {
namespace {

using nlohmann::json;
using test::gltf_triangle;
using test::GltfFile;
using test::only_mesh;

constexpr float rounding = 1e-6f;

/// A triangle whose node is animated: two keys, at 1 and 3 seconds.
template <typename Number>
GltfFile animated(const char* path, const std::vector<Number>& values, const char* type,
                  const char* interpolation = "LINEAR") {
  GltfFile file = gltf_triangle();
  const int times = file.accessor<float>({1, 3}, "SCALAR");
  const int output = file.accessor<Number>(values, type, !std::is_same_v<Number, float>);
  file.json["animations"] = {
      {{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}},
       {"samplers", {{{"input", times}, {"output", output}, {"interpolation", interpolation}}}}}};
  return file;
}

/// Where the triangle's second corner is at a time.
Vec3 corner_at(const GltfFile& file, std::optional<double> time) {
  return only_mesh(file.load({.time = time})).positions[1];
}

/// The triangle with two joints, of which the second one moves.
GltfFile skinned() {
  GltfFile file = gltf_triangle();
  auto& attributes = file.primitive()["attributes"];
  attributes["NORMAL"] = file.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  attributes["JOINTS_0"] = file.accessor<std::uint8_t>({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, "VEC4");
  attributes["WEIGHTS_0"] = file.accessor<float>({1, 0, 0, 0, 0, 1, 0, 0, 0.5f, 0.5f, 0, 0}, "VEC4");
  std::vector<float> matrices(32, 0.0f);
  for (std::size_t i = 0; i < 8; ++i) matrices[i / 4 * 16 + i % 4 * 5] = 1;
  matrices[16 + 12] = -1;  // The second joint rests at x = 1.
  file.json["skins"] = {
      {{"joints", {1, 2}}, {"inverseBindMatrices", file.accessor<float>(matrices, "MAT4")}}};
  file.json["nodes"][0]["skin"] = 0;
  file.json["nodes"][0]["translation"] = {100, 0, 0};  // which a skin replaces
  file.add_node({{"children", {2}}});
  file.json["nodes"].push_back({{"translation", {1, 0, 0}}});
  return file;
}

}  // namespace

TEST_CASE("gltf: morph targets move vertices by the weights of the mesh or, if it has some, the node") {
  GltfFile file = gltf_triangle();
  const int up = file.accessor<float>({0, 0, 0, 0, 0, 4, 0, 0, 0}, "VEC3");
  const int along = file.accessor<float>({0, 0, 0, 2, 0, 0, 0, 0, 0}, "VEC3");
  file.primitive()["targets"] = {{{"POSITION", up}}, {{"POSITION", along}}};
  CHECK(corner_at(file, {}) == Vec3{1, 0, 0});
  file.json["meshes"][0]["weights"] = {0.5, 1};
  CHECK(corner_at(file, {}) == Vec3{3, 0, 2});
  file.json["nodes"][0]["weights"] = {0, 0.5};
  CHECK(corner_at(file, {}) == Vec3{2, 0, 0});
  file.json["accessors"][std::size_t(along)]["count"] = 2;
  CHECK(file.error() ==
        "test.gltf: /meshes/0/primitives/0/targets/1/POSITION: 2 values for 3 positions; there must be as "
        "many");
}

TEST_CASE("gltf: a skin at rest leaves the mesh where it was made, wherever its node is") {
  const LoadedScene loaded = skinned().load();
  CHECK(loaded.warnings.empty());
  CHECK(only_mesh(loaded).positions == only_mesh(gltf_triangle().load()).positions);
  CHECK(only_mesh(loaded).normals[1] == Vec3{0, 0, 1});
}

TEST_CASE("gltf: vertices follow their joints by weight, and normals with them") {
  GltfFile file = skinned();
  file.json["nodes"][2]["rotation"] = {0, std::sqrt(0.5), 0, std::sqrt(0.5)};  // 90 degrees about y
  const LoadedScene loaded = file.load();
  const Mesh& mesh = only_mesh(loaded);
  CHECK(length(mesh.positions[0] - Vec3{0, 0, 0}) < rounding);
  CHECK(length(mesh.positions[1] - Vec3{1, 0, 0}) < rounding);
  CHECK(length(mesh.positions[2] - Vec3{0.5f, 1, 0.5f}) < rounding);  // half of 0 1 0, half of 1 1 1
  CHECK(length(mesh.normals[1] - Vec3{1, 0, 0}) < rounding);
}

TEST_CASE("gltf: where the joints of a skin mirror it, the front stays the front") {
  GltfFile file = skinned();
  file.json["nodes"][1]["scale"] = {1, 1, -1};
  file.json["nodes"][1]["translation"] = {0, 0, 2};
  const LoadedScene loaded = file.load();
  const Mesh& mesh = only_mesh(loaded);
  const auto corner = [&](std::size_t i) { return mesh.positions[mesh.triangles[0][i]]; };
  CHECK(corner(0) == Vec3{0, 0, 2});
  CHECK(corner(1) == Vec3{0, 1, 2});  // clockwise from above: the front is below
  CHECK(corner(2) == Vec3{1, 0, 2});
  CHECK(mesh.normals[mesh.normal_indices[0][0]] == Vec3{0, 0, -1});
}

TEST_CASE("gltf: joints and matrices that are not there are errors") {
  GltfFile file = skinned();
  file.json["skins"][0]["joints"] = {1};
  CHECK(file.error() == "test.gltf: /meshes/0/primitives/0: vertex 1 names the joint 1; the skin has 1");
  file.json["skins"][0]["joints"] = {1, 2, 0};
  CHECK(file.error() == "test.gltf: /skins/0/inverseBindMatrices: 2 matrices for 3 joints");
  file.json["skins"][0]["joints"] = json::array();
  CHECK(file.error() == "test.gltf: /skins/0/joints: 0 elements; valid are 1 and more");
}

TEST_CASE("gltf: at rest unless a time is given, and still before the first key and behind the last") {
  const GltfFile file = animated<float>("translation", {10, 0, 0, 20, 0, 0}, "VEC3");
  CHECK(corner_at(file, {}).x == 1);
  CHECK(corner_at(file, 0).x == 11);
  CHECK(corner_at(file, 1.5).x == 13.5f);
  CHECK(corner_at(file, 3).x == 21);
  CHECK(corner_at(file, 99).x == 21);
  const auto summary = file.load().summary;
  REQUIRE(summary.animation);
  CHECK(summary_lines(summary)[3] ==
        "animation: 1 to 3 s, shown at rest; --time=T shows another moment, --time=T,END motion");
  CHECK(summary_lines(file.load({.time = 2}).summary)[3] == "animation: 1 to 3 s, shown at 2 s");
  CHECK_FALSE(gltf_triangle().load().summary.animation);
}

TEST_CASE("gltf: steps stay at a key until the next one") {
  const GltfFile file = animated<float>("scale", {2, 2, 2, 5, 5, 5}, "VEC3", "STEP");
  CHECK(corner_at(file, 2.999).x == 2);
  CHECK(corner_at(file, 3).x == 5);
}

TEST_CASE("gltf: rotations turn evenly and the shorter way, as normalised integers too") {
  const float half = std::sqrt(0.5f);
  // From none to 90 degrees about z, whose quaternion is given with the other sign.
  const GltfFile file = animated<float>("rotation", {0, 0, 0, 1, 0, 0, -half, -half}, "VEC4");
  constexpr double third = 1 + 2.0 / 3;
  CHECK(length(corner_at(file, third) - Vec3{std::sqrt(0.75f), 0.5f, 0}) < rounding);
  const GltfFile coarse = animated<std::int16_t>("rotation", {0, 0, 0, 32767, 0, 0, 23170, 23170}, "VEC4");
  CHECK(length(corner_at(coarse, third) - Vec3{std::sqrt(0.75f), 0.5f, 0}) < 1e-4f);
}

TEST_CASE("gltf: splines have their tangents, in units of a second") {
  // Tangent in, value, tangent out of each key: from 0, leaving at 1 a second, to 6, arriving at 5 a second:
  // the parabola s + s^2 of the seconds s since the first key.
  const GltfFile file = animated<float>("translation", {9, 9, 9, 0, 0, 0, 1, 0, 0, 5, 0, 0, 6, 0, 0, 9, 9, 9},
                                        "VEC3", "CUBICSPLINE");
  for (const double s : {0.0, 0.5, 1.0, 1.75, 2.0}) {
    INFO(s);
    CHECK(corner_at(file, 1 + s).x - 1 == Approx(s + s * s).margin(1e-5));
  }
}

TEST_CASE("gltf: weights of morph targets are animated, all of a key together") {
  GltfFile file = animated<float>("weights", {0, 1, 1, 0}, "SCALAR");
  file.primitive()["targets"] = {{{"POSITION", file.accessor<float>({0, 0, 0, 0, 0, 4, 0, 0, 0}, "VEC3")}},
                                 {{"POSITION", file.accessor<float>({0, 0, 0, 2, 0, 0, 0, 0, 0}, "VEC3")}}};
  CHECK(corner_at(file, 1.5) == Vec3{1 + 0.75f * 2, 0, 0.25f * 4});
}

TEST_CASE("gltf: faults of animations have their place") {
  GltfFile file = animated<float>("translation", {10, 0, 0, 20, 0, 0}, "VEC3");
  file.json["accessors"][2]["count"] = 1;
  CHECK(file.error({.time = 0}) ==
        "test.gltf: /animations/0/samplers/0/output: 3 numbers for 2 keys; there must be 6");
  CHECK(file.error().empty());
  file = animated<float>("translation", {10, 0, 0, 20, 0, 0}, "VEC3");
  file.json["animations"][0]["channels"][0]["sampler"] = 4;
  CHECK(file.error({.time = 0}) ==
        "test.gltf: /animations/0/channels/0/sampler: the index 4 is out of range; valid are 0 to 0");
  file = animated<float>("translation", {10, 0, 0, 20, 0, 0}, "VEC3");
  file.json["accessors"][1]["count"] = 1;
  file.json["accessors"][1]["sparse"] = nullptr;
  file.json["accessors"][1].erase("sparse");
  file.buffer.replace(36, 4, file.buffer.substr(40, 4));  // both keys at 3
  file.json["accessors"][1]["count"] = 2;
  CHECK(file.error({.time = 0}) ==
        "test.gltf: /animations/0/samplers/0/input: the time 3 (number 1) is not behind the one before it");
}

}  // namespace twinray

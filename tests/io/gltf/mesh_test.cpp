// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/primitive.h"

#include "core/light_set.h"
#include "tests/io/gltf/file.h"
#include "tests/support/catch.h"

namespace twinray {
namespace {

using test::gltf_triangle;
using test::GltfFile;
using test::only_mesh;

/// Positions of a strip of three triangles: 0 2 4 above, 1 3 below.
const std::vector<float> strip{0, 1, 0, 0, 0, 0, 1, 1, 0, 1, 0, 0, 2, 1, 0};

GltfFile strip_file(int mode) {
  GltfFile file;
  file.show({{"attributes", {{"POSITION", file.accessor<float>(strip, "VEC3")}}}, {"mode", mode}});
  return file;
}

/// The triangle's three corners by this kind of numbers.
template <typename Number>
GltfFile indexed() {
  GltfFile file = gltf_triangle();
  file.primitive()["indices"] = file.accessor<Number>({2, 0, 1}, "SCALAR");
  return file;
}

/// The triangle whose corners x 0 0, 0 x 0 and 0 0 x are numbers of this kind.
template <typename Number>
std::vector<Vec3> positions_of(Number x, bool is_normalized) {
  GltfFile file;
  const int positions = file.accessor<Number>({x, 0, 0, 0, 0, x, 0, 0, 0, 0, x, 0}, "VEC4", is_normalized);
  file.json["accessors"][0]["type"] = "VEC3";
  file.json["bufferViews"][0]["byteStride"] = 4 * sizeof(Number);
  file.json["extensionsUsed"] = {"KHR_mesh_quantization"};
  file.show({{"attributes", {{"POSITION", positions}}}});
  return only_mesh(file.load()).positions;
}

}  // namespace

TEST_CASE("gltf: a triangle is where it is, faces +z and shades flat") {
  const LoadedScene loaded = gltf_triangle().load();
  CHECK(loaded.warnings.empty());
  CHECK(only_mesh(loaded).positions == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(only_mesh(loaded).normals.empty());
  CHECK(loaded.scene.geometry->facet(0, 0).normal == Vec3{0, 0, 1});
  CHECK(loaded.summary.triangles == 1);
  CHECK(loaded.summary.camera.empty());
}

TEST_CASE("gltf: strips and fans keep the side that they face") {
  const LoadedScene list = strip_file(5).load(), fan = strip_file(6).load();
  CHECK(only_mesh(list).triangles == std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}});
  for (std::uint32_t i = 0; i < 3; ++i) CHECK(list.scene.geometry->facet(0, i).normal == Vec3{0, 0, 1});
  CHECK(only_mesh(fan).triangles == std::vector<Triangle>{{1, 2, 0}, {2, 3, 0}, {3, 4, 0}});
}

TEST_CASE("gltf: indices have 8, 16 or 32 bits") {
  CHECK(only_mesh(indexed<std::uint8_t>().load()).triangles == std::vector<Triangle>{{2, 0, 1}});
  CHECK(only_mesh(indexed<std::uint16_t>().load()).triangles == std::vector<Triangle>{{2, 0, 1}});
  CHECK(only_mesh(indexed<std::uint32_t>().load()).triangles == std::vector<Triangle>{{2, 0, 1}});
  CHECK(indexed<float>().error() ==
        "test.gltf: /accessors/1/componentType: this is 5126; valid for indices are 5121, 5123 and 5125");
}

TEST_CASE("gltf: points and lines are left out, and counted") {
  GltfFile file = gltf_triangle();
  const auto attributes = file.primitive()["attributes"];
  for (const int mode : {0, 0, 1, 3}) file.show({{"attributes", attributes}, {"mode", mode}});
  const auto warnings = file.load().warnings;
  REQUIRE(warnings.size() == 2);
  CHECK(warnings[0].text() ==
        "test.gltf: /meshes/1/primitives/0: points are not rendered; this primitive is left out (2 times)");
  CHECK(warnings[1].text() ==
        "test.gltf: /meshes/3/primitives/0: lines are not rendered; this primitive is left out (2 times)");
  CHECK(file.load().summary.triangles == 1);
}

TEST_CASE("gltf: integers are numbers as they stand or, normalised, up to 1") {
  CHECK(positions_of<std::int8_t>(127, true)[0].x == 1);
  CHECK(positions_of<std::int8_t>(-128, true)[0].x == -1);
  CHECK(positions_of<std::uint8_t>(51, true)[0].x == 0.2f);
  CHECK(positions_of<std::int16_t>(-32767, true)[0].x == -1);
  CHECK(positions_of<std::uint16_t>(13107, true)[0].x == 0.2f);
  CHECK(positions_of<std::int8_t>(-128, false)[0].x == -128);
  CHECK(positions_of<std::uint16_t>(40000, false)[0].x == 40000);
  CHECK(positions_of<float>(0.25f, false)[0].x == 0.25f);
}

TEST_CASE("gltf: positions and normals may stand in turn in one view") {
  GltfFile file = gltf_triangle();
  const int view = file.view(test::bytes_of<float>({0, 0, 0, 0, 0, 1, 3, 0, 0, 0, 1, 0, 0, 4, 0, 1, 0, 0}));
  file.json["bufferViews"][std::size_t(view)]["byteStride"] = 24;
  const auto every_other = [&](int first_byte) {
    return file.add("accessors", {{"bufferView", view},
                                  {"byteOffset", first_byte},
                                  {"componentType", 5126},
                                  {"count", 3},
                                  {"type", "VEC3"}});
  };
  file.primitive()["attributes"] = {{"POSITION", every_other(0)}, {"NORMAL", every_other(12)}};
  const LoadedScene loaded = file.load();
  CHECK(only_mesh(loaded).positions == std::vector<Vec3>{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}});
  CHECK(only_mesh(loaded).normals == std::vector<Vec3>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}});
}

TEST_CASE("gltf: sparse accessors replace elements, of zeros where there are no others") {
  GltfFile file = gltf_triangle();
  const int indices = file.view(test::bytes_of<std::uint16_t>({1, 2}));
  const int values = file.view(test::bytes_of<float>({3, 0, 0, 0, 4, 0}));
  auto& accessor = file.json["accessors"][0];
  accessor["sparse"] = {{"count", 2},
                        {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                        {"values", {{"bufferView", values}}}};
  const std::vector<Vec3> expected{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
  CHECK(only_mesh(file.load()).positions == expected);
  accessor.erase("bufferView");
  CHECK(only_mesh(file.load()).positions == expected);
  accessor["sparse"]["count"] = 4;
  CHECK(file.error() == "test.gltf: /accessors/0/sparse/count: 4 elements of 3 are replaced");
}

TEST_CASE("gltf: indices may be sparse, and zeros where there are no others") {
  GltfFile file = gltf_triangle();
  const int places = file.view(test::bytes_of<std::uint16_t>({1, 2}));
  const int values = file.view(test::bytes_of<std::uint16_t>({2, 1}));
  const int accessor = int(file.json["accessors"].size());
  file.json["accessors"].push_back({{"componentType", 5123},
                                    {"count", 3},
                                    {"type", "SCALAR"},
                                    {"sparse",
                                     {{"count", 2},
                                      {"indices", {{"bufferView", places}, {"componentType", 5123}}},
                                      {"values", {{"bufferView", values}}}}}});
  file.primitive()["indices"] = accessor;
  CHECK(only_mesh(file.load()).triangles == std::vector<Triangle>{{0, 2, 1}});
  // What the reader calls them on their way is no name for a file.
  file.primitive().erase("indices");
  file.primitive()["extensions"]["twinray_indices"] = {{"indices", 1000000}};
  CHECK(only_mesh(file.load()).triangles == std::vector<Triangle>{{0, 1, 2}});
}

TEST_CASE("gltf: nodes move what is below them, by matrices and by their three parts") {
  GltfFile file = gltf_triangle();
  file.json["nodes"][0]["translation"] = {0, 0, 5};
  file.json["nodes"][0]["rotation"] = {0, 0, std::sqrt(0.5), std::sqrt(0.5)};  // 90 degrees about z
  file.json["nodes"][0]["scale"] = {2, 3, 1};
  file.json["nodes"].push_back(
      {{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 10, 0, 0, 1}}, {"children", {0}}});
  file.json["scenes"][0]["nodes"] = {1};
  const auto positions = only_mesh(file.load()).positions;
  CHECK(length(positions[1] - Vec3{10, 2, 5}) < 1e-6f);
  CHECK(length(positions[2] - Vec3{7, 0, 5}) < 1e-6f);
}

TEST_CASE("gltf: where a transform mirrors, the front stays the front") {
  GltfFile file = gltf_triangle();
  file.primitive()["attributes"]["NORMAL"] = file.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  file.json["nodes"][0]["scale"] = {-1, 1, 1};
  const LoadedScene loaded = file.load();
  CHECK(loaded.scene.geometry->facet(0, 0).normal == Vec3{0, 0, 1});
  CHECK(only_mesh(loaded).normals[0] == Vec3{0, 0, 1});
}

TEST_CASE("gltf: the file's scene is shown or, where it says none, the first") {
  GltfFile file = gltf_triangle();
  file.json["nodes"].push_back({{"mesh", 0}, {"translation", {0, 0, 7}}});
  file.json["scenes"].push_back({{"nodes", {1}}});
  CHECK(only_mesh(file.load()).positions[0].z == 0);
  file.json["scene"] = 1;
  CHECK(only_mesh(file.load()).positions[0].z == 7);
  CHECK(file.load().summary.notes == std::vector<std::string>{"the file has 2 scenes; this is number 1"});
  file.json.erase("scene");
  file.json.erase("scenes");
  CHECK(file.load().summary.triangles == 2);
  CHECK(file.warning() == "test.gltf: /: the file has no scene; all its nodes are shown");
}

TEST_CASE("gltf: instances are of meshes that do not emit alone, and these have numbers without gaps") {
  GltfFile file = gltf_triangle();
  file.primitive()["material"] = file.add("materials", {{"emissiveFactor", {1, 1, 1}}});
  file.add_node({{"mesh", 0}});
  const auto dark = file.primitive()["attributes"];
  file.show({{"attributes", dark}});
  file.add_node({{"mesh", 1}, {"translation", {0, 0, 1}}});
  const Scene scene = file.load({.instances = InstanceUse::keep}).scene;
  CHECK(scene.lights.size() == 2);
  REQUIRE(scene.geometry->prototypes().size() == 1);
  CHECK(scene.geometry->prototypes()[0].count == 1);
  REQUIRE(scene.geometry->instances().size() == 2);
  CHECK(scene.geometry->instances()[1].prototype == 0);
}

TEST_CASE("gltf: what EXT_mesh_gpu_instancing shows lies within its node, copied or not") {
  GltfFile file = gltf_triangle();
  const int places = file.accessor<float>({0, 0, 1, 0, 0, 2}, "VEC3");
  const int sizes = file.accessor<float>({1, 1, 1, 2, 2, 2}, "VEC3");
  file.json["nodes"][0]["translation"] = {0, 0, 10};
  file.json["nodes"][0]["name"] = "trees";
  file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", places},
                                                                                  {"SCALE", sizes}};
  const LoadedScene loaded = file.load();
  REQUIRE(loaded.summary.meshes == 2);
  CHECK(loaded.scene.geometry->mesh(1)->positions[1] == Vec3{2, 0, 12});
  CHECK(loaded.scene.assets == std::vector<std::string>{"trees"});
  CHECK(asset_of(loaded.scene, 0) == asset_of(loaded.scene, 1));
  LoadOptions keep;
  keep.instances = InstanceUse::keep;
  const LoadedScene kept = file.load(keep);
  CHECK(kept.summary.meshes == 1);
  REQUIRE(kept.summary.instances == 2);
  CHECK(kept.summary.repeated == 1);
  CHECK(loaded.summary.repeated == 1);
  CHECK(kept.scene.geometry->bounds().upper == loaded.scene.geometry->bounds().upper);
  CHECK(kept.scene.geometry->instances()[1].to_world.point({1, 0, 0}) == Vec3{2, 0, 12});
  CHECK(asset_of(kept.scene, 0) == 0);
  const std::size_t materials = kept.scene.materials.size();
  GltfFile far = file;
  far.json["nodes"][0]["translation"] = {2e12, 0, 10};
  CHECK(far.error(keep).find("test.gltf: /nodes/0: this instance reaches to (2e+12,") == 0);
  // What emits is copied, and is a light for each; nothing is left for instances.
  file.json["materials"] = {{{"emissiveFactor", {1, 1, 1}}}};
  file.primitive()["material"] = 0;
  const LoadedScene glowing = file.load(keep);
  CHECK(glowing.summary.instances == 0);
  CHECK(glowing.summary.meshes == 2);
  CHECK(glowing.scene.lights.size() == 2);
  CHECK(glowing.scene.materials.size() == materials);
  file.json["accessors"][std::size_t(sizes)]["count"] = 1;
  CHECK(file.error() ==
        "test.gltf: /nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/SCALE: 1 values for 2 instances; "
        "there must be as many");
}

TEST_CASE("gltf: texture coordinates run upwards here, and downwards there") {
  GltfFile file = test::gltf_surface({{"name", "wood"}});
  file.json["textures"] = nlohmann::json::array({nlohmann::json::object()});
  file.json["materials"][0]["emissiveTexture"] = {{"index", 0}};
  CHECK(only_mesh(file.load()).uvs == std::vector<Vec2>{{0, 0}, {1, 0}, {0, 1}});
}

TEST_CASE("gltf: colors of vertices are a picture that mixes them as their triangle does") {
  GltfFile file = gltf_triangle();
  file.primitive()["attributes"]["COLOR_0"] =
      file.accessor<float>({1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 0.5f}, "VEC4");
  file.primitive()["material"] = file.add("materials", {{"alphaMode", "BLEND"}});
  const LoadedScene loaded = file.load();
  const Mesh& mesh = only_mesh(loaded);
  const Material& material = loaded.scene.materials[0];
  REQUIRE(material.textures.size() == 1);
  CHECK(material.textures[0].input == MaterialInput::reflectance);
  const auto value = [&](std::uint32_t texture, float u, float v) {
    const auto& [a, b, c] = mesh.uv_indices[0];
    const Vec2 uv = mesh.uvs[a] * (1 - u - v) + mesh.uvs[b] * u + mesh.uvs[c] * v;
    return evaluate(loaded.scene.textures, texture, {.uv = uv, .footprint = 1});
  };
  constexpr float rounding = 1e-6f;
  const Rgb mixed = value(material.textures[0].texture, 0.25f, 0.5f);
  CHECK(std::abs(mixed.r - 0.25f) + std::abs(mixed.g - 0.25f) + std::abs(mixed.b - 0.5f) < rounding);
  CHECK(std::abs(value(loaded.scene.bindings[0].alpha, 0.25f, 0.5f).r - 0.75f) < rounding);
  file.add_node({{"mesh", 0}});
  CHECK(file.load().scene.textures.size() == loaded.scene.textures.size());
  CHECK(file.load().scene.materials.size() == 1);
  file.json["materials"][0]["extensions"]["KHR_materials_unlit"] = nlohmann::json::object();
  const LoadedScene unlit = file.load();
  const auto light = std::get<MeshLight>(unlit.scene.lights.at(0).source);
  REQUIRE(light.picture);
  const Mesh& own = only_mesh(unlit);
  CHECK(own.positions[own.triangles[0][2]] == Vec3{1, 0, 0});  // The darkest corner, the blue one, is first.
  CHECK(bilinear(*light.picture, WrapMode::clamp, own.uvs[own.uv_indices[0][2]]) == Rgb{0, 1, 0});
}

TEST_CASE("gltf: an unlit triangle emits, whichever corner alone is bright") {
  for (std::size_t bright = 0; bright < 3; ++bright) {
    GltfFile file = gltf_triangle();
    std::vector<float> colors(9, 0.0f);
    std::fill_n(colors.begin() + std::ptrdiff_t(3 * bright), 3, 1.0f);
    file.primitive()["attributes"]["COLOR_0"] = file.accessor<float>(colors, "VEC3");
    file.primitive()["material"] =
        file.add("materials", {{"extensions", {{"KHR_materials_unlit", nlohmann::json::object()}}}});
    const LoadedScene loaded = file.load();
    REQUIRE(loaded.scene.lights.size() == 1);
    const auto& light = std::get<MeshLight>(loaded.scene.lights[0].source);
    REQUIRE(light.picture);
    const Mesh& mesh = only_mesh(loaded);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 at = mesh.positions[mesh.triangles[0][i]];
      const std::size_t corner = at.x == 1 ? 1 : at.y == 1 ? 2 : 0;
      CHECK(bilinear(*light.picture, WrapMode::clamp, mesh.uvs[mesh.uv_indices[0][i]]).g ==
            (corner == bright ? 1 : 0));
    }
  }
}

TEST_CASE("gltf: an unlit triangle of red, green and blue corners emits no less than nothing") {
  GltfFile file = gltf_triangle();
  const std::vector<float> corners{1, 0, 0, 0, 1, 0, 0, 0, 1};
  file.primitive()["attributes"]["COLOR_0"] = file.accessor<float>(corners, "VEC3");
  file.primitive()["material"] =
      file.add("materials", {{"extensions", {{"KHR_materials_unlit", nlohmann::json::object()}}}});
  const LoadedScene loaded = file.load();
  const LightSet lights(loaded.scene);
  const Geometry& geometry = *loaded.scene.geometry;
  for (const auto& [u, v, is_within] :
       {std::tuple{0.0f, 0.0f, true}, {0.25f, 0.25f, true}, {0.5f, 0.5f, true}, {1.0f, 1.0f, false}}) {
    SurfacePoint point = triangle_point(geometry, 0, 0, u, v);
    point.uv = texture_coordinates(geometry, {.t = 1, .u = u, .v = v});
    const Rgb light = lights.emitted(point, point.geometric_normal);
    CHECK(at_least_zero(light) == light);
    if (is_within) CHECK(light.r + light.g + light.b == Approx(1).epsilon(1e-6));
  }
}

TEST_CASE("gltf: one color of all vertices goes with any texture") {
  GltfFile file = gltf_triangle();
  const std::vector<std::uint16_t> red{65535, 0, 0, 65535, 0, 0, 65535, 0, 0};
  file.primitive()["attributes"]["COLOR_0"] = file.accessor<std::uint16_t>(red, "VEC3", true);
  const auto color = [&] {
    const LoadedScene loaded = file.load();
    CHECK(loaded.warnings.empty());
    REQUIRE(loaded.scene.materials[0].textures.size() == 1);
    return evaluate(loaded.scene.textures, loaded.scene.materials[0].textures[0].texture, {});
  };
  CHECK(color() == Rgb{1, 0, 0});
  file.primitive()["attributes"]["TEXCOORD_0"] = file.accessor<float>({0, 1, 1, 1, 0, 0}, "VEC2");
  file.primitive()["material"] =
      file.add("materials", {{"pbrMetallicRoughness",
                              {{"baseColorFactor", {0.5, 1, 1, 1}}, {"baseColorTexture", {{"index", 0}}}}}});
  file.json["textures"] = {{{"source", 0}}};
  const std::string white_png =
      "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR42mP4//8/AAX+Av4zEpUUAAAAAElFTkSuQmCC";
  file.json["images"] = {{{"uri", "data:image/png;base64," + white_png}}};
  CHECK(color() == Rgb{0.5f, 0, 0});
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Textures, and colours of vertices, by one set of coordinates or another.
#include "core/surface.h"
#include "io/picture/srgb.h"
#include "tests/io/gltf/surface.h"
#include "tests/support/round_trip.h"

namespace twinray::test {
namespace {

using nlohmann::json;

/// What an input of the first material is at a point of the only triangle, by the weights of its corners.
Rgb input_within(const Scene& scene, MaterialInput input, float u, float v) {
  const Hit hit{.t = 1, .u = u, .v = v};
  const TexturePoint at{.uv = texture_coordinates(*scene.geometry, hit),
                        .second_uv = texture_coordinates(*scene.geometry, hit, CoordinateSet::second)};
  const TextureUse* const use = texture_use(scene.materials[0], input);
  return use ? evaluate(scene.textures, use->texture, at) : Rgb{-1, -1, -1};
}

/// A triangle whose TEXCOORD_0 is on the left half of pictures throughout, whose TEXCOORD_1 is on the right
/// one, and whose base color goes by the first.
GltfFile two_sets() {
  GltfFile file = gltf_surface(json::object());
  json& attributes = file.primitive()["attributes"];
  attributes["TEXCOORD_0"] = file.accessor<float>({0.1f, 0.5f, 0.2f, 0.5f, 0.2f, 0.6f}, "VEC2");
  attributes["TEXCOORD_1"] = file.accessor<float>({0.8f, 0.5f, 0.9f, 0.5f, 0.9f, 0.6f}, "VEC2");
  file.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] =
      add_picture(file, {{"magFilter", 9728}});
  return file;
}

json by_set(int set) { return {{"index", 0}, {"texCoord", set}}; }

}  // namespace

TEST_CASE("gltf: textures of one material go by two sets of coordinates") {
  GltfFile file = two_sets();
  json& metallic = file.json["materials"][0]["pbrMetallicRoughness"];
  metallic["metallicRoughnessTexture"] = by_set(1);
  const LoadedScene loaded = file.load();
  CHECK(loaded.warnings.empty());
  CHECK(input_within(loaded.scene, MaterialInput::reflectance, 0.25f, 0.5f).b == 0);
  CHECK(input_within(loaded.scene, MaterialInput::base_metalness, 0.25f, 0.5f).r == 1);
  metallic["metallicRoughnessTexture"]["texCoord"] = 0;
  metallic["baseColorTexture"]["texCoord"] = 1;
  const LoadedScene swapped = file.load();
  CHECK(swapped.warnings.empty());
  CHECK(input_within(swapped.scene, MaterialInput::reflectance, 0.25f, 0.5f).b == 1);
  CHECK(input_within(swapped.scene, MaterialInput::base_metalness, 0.25f, 0.5f).r == 0);
}

TEST_CASE("gltf: a texture that cannot go by its coordinates is left out, and told") {
  const std::string pointer = "test.gltf: /materials/0";
  GltfFile file = two_sets();
  json& material = file.json["materials"][0];
  material["normalTexture"] = by_set(1);
  CHECK(file.warning() ==
        pointer +
            "/normalTexture: a texture of this kind must go by the coordinates of most, here "
            "TEXCOORD_0; this one goes by TEXCOORD_1, and is left out");
  material.erase("normalTexture");
  file.primitive()["attributes"]["TEXCOORD_2"] = file.accessor<float>({0, 0, 0, 0, 0, 0}, "VEC2");
  material["pbrMetallicRoughness"]["metallicRoughnessTexture"] = by_set(2);
  material["extensions"]["KHR_materials_sheen"] = {{"sheenColorFactor", {1, 1, 1}},
                                                   {"sheenColorTexture", by_set(1)}};
  file.json["extensionsUsed"] = {"KHR_materials_sheen"};
  const LoadedScene three = file.load();
  REQUIRE(three.warnings.size() == 1);
  CHECK(three.warnings[0].message ==
        "two sets of texture coordinates are rendered, here TEXCOORD_0 and TEXCOORD_2; this texture goes by "
        "TEXCOORD_1, and is left out");
  file.primitive()["attributes"].erase("TEXCOORD_0");
  const LoadedScene none = file.load();
  CHECK(none.scene.materials[0].textures.empty());
  CHECK(none.warnings.size() == 3);
}

TEST_CASE("gltf: coordinates that a mesh does not have are called that, whatever others it has") {
  GltfFile file = two_sets();
  json& material = file.json["materials"][0];
  const std::string missing = ": the mesh has no TEXCOORD_3; this texture is left out";
  material["normalTexture"] = by_set(3);
  CHECK(file.warning() == "test.gltf: /materials/0/normalTexture" + missing);
  material.erase("normalTexture");
  json& metallic = material["pbrMetallicRoughness"];
  metallic["metallicRoughnessTexture"] = by_set(3);
  CHECK(file.warning() ==
        "test.gltf: /materials/0/pbrMetallicRoughness/metallicRoughnessTexture" + missing + " (2 times)");
  metallic["baseColorTexture"] = by_set(1);
  file.json["extensionsUsed"] = {"KHR_materials_sheen"};
  material["extensions"]["KHR_materials_sheen"] = {{"sheenColorFactor", {1, 1, 1}},
                                                   {"sheenColorTexture", by_set(0)}};
  metallic.erase("metallicRoughnessTexture");
  CHECK(file.load().warnings.empty());
}

TEST_CASE("gltf: sets of texture coordinates may have numbers of several digits") {
  GltfFile file = two_sets();
  json& attributes = file.primitive()["attributes"];
  attributes["TEXCOORD_10"] = attributes["TEXCOORD_1"];
  file.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 10;
  const LoadedScene loaded = file.load();
  CHECK(loaded.warnings.empty());
  CHECK(input_within(loaded.scene, MaterialInput::reflectance, 0.25f, 0.5f).b == 1);
}

TEST_CASE("gltf: colors of vertices multiply a texture, and are mixed as their triangle mixes them") {
  GltfFile file = two_sets();
  json& attributes = file.primitive()["attributes"];
  attributes.erase("TEXCOORD_1");
  attributes["COLOR_0"] = file.accessor<float>({1, 0, 1, 0, 1, 1, 0, 0, 1}, "VEC3");
  const LoadedScene loaded = file.load();
  CHECK(loaded.warnings.empty());
  const Rgb pixel{decode_srgb(188 / 255.0f), decode_srgb(51 / 255.0f), 0};
  for (const Vec2 at : {Vec2{0, 0}, {0.25f, 0.5f}, {0.75f, 0.125f}}) {
    const Rgb found = input_within(loaded.scene, MaterialInput::reflectance, at.x, at.y);
    CHECK(found.r == Approx(pixel.r * (1 - at.x - at.y)).margin(1e-6));
    CHECK(found.g == Approx(pixel.g * at.x).margin(1e-6));
    CHECK(found.b == 0);
  }
  attributes["COLOR_0"] = file.accessor<float>({1, 0, 1, 0.5f, 0, 1, 1, 1, 0, 0, 1, 1}, "VEC4");
  CHECK(file.warning() ==
        "test.gltf: /meshes/0/primitives/0/attributes/COLOR_0: alphas of vertices beside textures are left "
        "out");
  file.json["materials"][0]["extensions"]["KHR_materials_unlit"] = json::object();
  CHECK(file.warning() ==
        "test.gltf: /meshes/0/primitives/0/attributes/COLOR_0: colors of vertices beside these textures are "
        "left "
        "out");
}

TEST_CASE("gltf: parts of a mesh whose coordinates are mirrored keep the colors of their vertices") {
  GltfFile file;
  const int positions = file.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0, 1, 2, 0}, "VEC3");
  file.show({{"attributes", {{"POSITION", positions}}}});
  json& attributes = file.primitive()["attributes"];
  attributes["TEXCOORD_0"] = file.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0}, "VEC2");
  attributes["COLOR_0"] =
      file.accessor<float>({1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0}, "VEC3");
  file.primitive()["material"] = file.add("materials", json::object());
  const int picture = add_picture(file);
  file.json["materials"][0]["normalTexture"]["index"] = picture;
  const LoadedScene loaded = file.load();
  CHECK(loaded.warnings.empty());
  REQUIRE(loaded.scene.geometry->shapes().size() == 2);
  for (std::uint32_t shape = 0; shape < 2; ++shape) {
    const Hit hit{.t = 1, .u = 0.25f, .v = 0.25f, .mesh = shape};
    const TexturePoint at{.second_uv =
                              texture_coordinates(*loaded.scene.geometry, hit, CoordinateSet::second)};
    const Material& material = loaded.scene.materials[loaded.scene.bindings[shape].material];
    const bool is_red = loaded.scene.geometry->mesh(shape)->positions[0].x == 0;
    CHECK(evaluate(loaded.scene.textures, texture_use(material, MaterialInput::reflectance)->texture, at) ==
          (is_red ? Rgb{1, 0, 0} : Rgb{0, 1, 0}));
  }
}

TEST_CASE("second coordinates are written in exchange form, other formats have the mean color") {
  GltfFile file = two_sets();
  file.json["materials"][0]["pbrMetallicRoughness"]["metallicRoughnessTexture"] = by_set(1);
  const Scene scene = file.load().scene;
  const RoundTrip exchanged = round_trip(scene, "a.json");
  CHECK(exchanged.warnings.empty());
  const auto metalness = [](const Scene& of) {
    return input_within(of, MaterialInput::base_metalness, 0.25f, 0.5f).r;
  };
  CHECK(metalness(exchanged.scene) == metalness(scene));
  CHECK(exchanged.scene.geometry->mesh(0)->second_uvs == scene.geometry->mesh(0)->second_uvs);
  for (const char* name : {"a.gltf", "a.pbrt"}) {
    const RoundTrip other = round_trip(scene, name);
    REQUIRE(!other.warnings.empty());
    CHECK(other.warnings[0].find("2 pictures by second texture coordinates are their mean colors") !=
          std::string::npos);
  }
  CHECK(metalness(round_trip(scene, "a.gltf").scene) == Approx(0.5).margin(0.01));
}

}  // namespace twinray::test

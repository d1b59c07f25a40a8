// SPDX-License-Identifier: Apache-2.0
// Facets of unequal widths in glTF files: how wide they are, and where.
#include "core/angle.h"
#include "core/textured_material.h"
#include "tests/io/gltf/surface.h"

namespace twinray::test {

using nlohmann::json;

TEST_CASE("gltf: anisotropy widens facets along the tangent, and keeps them across") {
  GltfFile file = extended("KHR_materials_anisotropy", {{"anisotropyStrength", 0.5}});
  file.json["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"] = 0.5;
  const Principled model = model_of(file);
  const float a = model.specular_roughness_anisotropy,
              r2 = model.specular_roughness * model.specular_roughness;
  const float along = r2 * std::sqrt(2 / (1 + (1 - a) * (1 - a)));
  CHECK(along == Approx(0.25 + 0.75 * 0.25));
  CHECK((1 - a) * along == Approx(0.25));
}

TEST_CASE("gltf: the direction of anisotropy is that of the texture coordinates, turned, and as mirrored") {
  GltfFile file =
      extended("KHR_materials_anisotropy", {{"anisotropyStrength", 0.5}, {"anisotropyRotation", 0.5}});
  const auto degrees = [&] {
    const LoadedScene loaded = file.load();
    CHECK(loaded.warnings.empty());
    CHECK_FALSE(only_mesh(loaded).uvs.empty());
    CHECK(loaded.scene.materials[0].tangent_map == no_texture);
    return loaded.scene.materials[0].tangent_degrees;
  };
  json& anisotropy = file.json["materials"][0]["extensions"]["KHR_materials_anisotropy"];
  CHECK(degrees() == Approx(0.5 * 180 / pi_double));
  anisotropy["anisotropyRotation"] = -20;  // Three turns, and -1.15 radians.
  CHECK(degrees() == Approx((6 * pi_double - 20) * 180 / pi_double));
  file.json["nodes"][0]["scale"] = {-1, 1, 1};
  CHECK(degrees() == Approx(-(6 * pi_double - 20) * 180 / pi_double));
  file.primitive()["attributes"].erase("TEXCOORD_0");
  CHECK(file.warning() ==
        "test.gltf: /materials/0/extensions/KHR_materials_anisotropy: the mesh has no texture coordinates, "
        "which the direction of its facets goes by; it is any direction");
}

TEST_CASE("gltf: a picture of anisotropy has its direction in red and green, and a factor of it in blue") {
  GltfFile file = gltf_surface(json::object());
  const int picture = add_picture(file);
  json& anisotropy = file.json["materials"][0]["extensions"]["KHR_materials_anisotropy"];
  anisotropy = {{"anisotropyStrength", 0.5}, {"anisotropyTexture", {{"index", picture}}}};
  const auto direction = [&] {
    const LoadedScene loaded = file.load();
    CHECK(loaded.warnings.empty());
    CHECK(loaded.scene.materials[0].textures.back().meaning == InputMeaning::widening);
    CHECK(input_at(loaded, MaterialInput::specular_roughness_anisotropy, left).r == 0);
    CHECK(input_at(loaded, MaterialInput::specular_roughness_anisotropy, right).r == 0.5f);
    return evaluate(loaded.scene.textures, loaded.scene.materials[0].tangent_map, {.uv = left});
  };
  CHECK(direction().r == Approx(188.0 / 255));
  CHECK(direction().g == Approx(51.0 / 255));
  file.json["nodes"][0]["scale"] = {1, 1, -1};
  CHECK(direction().r == Approx(188.0 / 255));
  CHECK(direction().g == Approx(1 - 51.0 / 255));
}

TEST_CASE("gltf: a picture of anisotropy alone says which texture coordinates count") {
  GltfFile file = gltf_surface(json::object());
  file.primitive()["attributes"]["TEXCOORD_1"] = file.accessor<float>({0, 1, 0, 0, 1, 1}, "VEC2");
  const int picture = add_picture(file);
  file.json["materials"][0]["extensions"]["KHR_materials_anisotropy"] = {
      {"anisotropyStrength", 0.5}, {"anisotropyTexture", {{"index", picture}, {"texCoord", 1}}}};
  const LoadedScene loaded = file.load();
  CHECK(loaded.warnings.empty());
  CHECK(loaded.scene.materials[0].tangent_map != no_texture);
  CHECK(only_mesh(loaded).uvs[1].y == 1);
}

TEST_CASE("gltf: anisotropy widens facets of a roughness that a picture says") {
  GltfFile file = gltf_surface(json::object());
  const int picture = add_picture(file);
  json& material = file.json["materials"][0];
  material["extensions"]["KHR_materials_anisotropy"] = {{"anisotropyStrength", 0.5}};
  material["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", picture}};
  const LoadedScene loaded = file.load();
  CHECK(loaded.warnings.empty());
  const Material& read = loaded.scene.materials[0];
  const auto model = std::get<Principled>(textured_model(read, loaded.scene.textures, {.uv = left}));
  const double r = 0.2, across = r * r, along = across + (1 - across) * 0.25;
  CHECK(1 - double(model.specular_roughness_anisotropy) == Approx(across / along));
}

}  // namespace twinray::test

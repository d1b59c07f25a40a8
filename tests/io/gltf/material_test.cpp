// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/material.h"

#include "core/elementary.h"
#include "core/textured_material.h"
#include "tests/io/gltf/surface.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {

using nlohmann::json;

TEST_CASE("gltf: a material without properties is a rough white metal, as is what has none") {
  const Principled plain = model_of(gltf_surface(json::object())), none = model_of(gltf_triangle());
  CHECK(plain.base_color == Rgb{1, 1, 1});
  CHECK(plain.base_metalness == 1);
  CHECK(plain.specular_roughness == 1);
  CHECK(none.base_metalness == 1);
  CHECK(gltf_triangle().load().scene.materials[0].name == "default");
}

TEST_CASE("gltf: factors of metal, roughness and color are OpenPBR's") {
  const Principled model = model_of(gltf_surface({{"pbrMetallicRoughness",
                                                   {{"baseColorFactor", {0.25, 0.5, 0.75, 1}},
                                                    {"metallicFactor", 0.125},
                                                    {"roughnessFactor", 0.625}}}}));
  CHECK(model.base_color == Rgb{0.25f, 0.5f, 0.75f});
  CHECK(model.base_metalness == 0.125f);
  CHECK(model.specular_roughness == 0.625f);
  CHECK(model.specular_ior == 1.5f);
}

TEST_CASE("gltf: colors are encoded as sRGB has it, roughness is green and metal blue as they stand") {
  GltfFile file = gltf_surface(json::object());
  const int picture = add_picture(file);
  file.json["materials"][0]["pbrMetallicRoughness"] = {{"baseColorFactor", {0.5, 1, 1, 1}},
                                                       {"baseColorTexture", {{"index", picture}}},
                                                       {"metallicRoughnessTexture", {{"index", picture}}},
                                                       {"roughnessFactor", 0.5}};
  const LoadedScene loaded = file.load();
  CHECK(loaded.warnings.empty());
  constexpr float half = 0.50288654f;  // 188 of 255, decoded
  CHECK(input_at(loaded, MaterialInput::reflectance, left).r == Approx(half / 2).margin(1e-5));
  CHECK(input_at(loaded, MaterialInput::roughness, left).r == Approx(0.5 * 51 / 255).margin(1e-6));
  CHECK(input_at(loaded, MaterialInput::roughness, right).r == Approx(0.5 * 102 / 255).margin(1e-6));
  CHECK(input_at(loaded, MaterialInput::base_metalness, left).r == 0);
  CHECK(input_at(loaded, MaterialInput::base_metalness, right).r == 1);
}

TEST_CASE("gltf: pictures stand in buffers, in the text, or in files beside it") {
  const TemporaryFolder folder;
  test::write_text(folder.file("a b.png"), picture_bytes());
  for (const char* uri : {"", "data:image/png;base64,", "data:image/png;base64,\r\n ", "a%20b.png"}) {
    INFO(uri);
    GltfFile file = gltf_surface(json::object());
    file.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = add_picture(file);
    if (*uri)
      file.json["images"][0] = {
          {"uri", std::string(uri) + (*uri == 'd' ? test::base64(picture_bytes()) : "")}};
    test::write_text(folder.file("scene.gltf"), file.text());
    const LoadOptions options{.files = std::make_shared<std::vector<std::string>>()};
    const LoadedScene loaded = load_gltf(folder.file("scene.gltf"), options);
    CHECK(loaded.warnings.empty());
    CHECK(input_at(loaded, MaterialInput::reflectance, right).b == 1);
    CHECK(options.files->size() == (*uri == 'a' ? 2 : 1));
  }
}

TEST_CASE("gltf: a picture that cannot be read is magenta, and a warning says so") {
  GltfFile file = gltf_surface(json::object());
  file.json["textures"] = {{{"source", 0}}};
  file.json["images"] = {{{"uri", "missing.png"}}};
  file.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 0;
  CHECK(file.warning() == "test.gltf: /images/0: missing.png: there is no such file; it is shown magenta");
  file.json["images"][0]["uri"] = "https://a.b/c.png";
  CHECK(file.warning() ==
        "test.gltf: /images/0: \"https://a.b/c.png\" lies on another machine; files of this one are read; it "
        "is "
        "shown magenta");
  file.json["images"][0]["uri"] = "data:image/gif;base64,R0lGODlhAQABAAAAACw=";
  CHECK(file.warning().find("it is shown magenta") != std::string::npos);
}

TEST_CASE("gltf: pictures repeat, end or are mirrored beside themselves") {
  const auto at = [](const json& sampler, Vec2 uv) {
    GltfFile file = gltf_surface(json::object());
    const int picture = add_picture(file, sampler);
    file.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = picture;
    const LoadedScene loaded = file.load();
    CHECK(loaded.warnings.empty());
    return input_at(loaded, MaterialInput::reflectance, uv).b;
  };
  constexpr int repeat = 10497, clamp = 33071, mirror = 33648;
  for (const int above : {repeat, clamp, mirror}) {
    const auto beside = [&](int wrap, Vec2 uv) { return at({{"wrapS", wrap}, {"wrapT", above}}, uv); };
    CHECK(beside(repeat, {1.25f, 0.5f}) == 0);  // the left pixel again
    CHECK(beside(clamp, {1.25f, 0.5f}) == 1);
    CHECK(beside(clamp, {2.25f, 0.5f}) == 1);
    CHECK(beside(mirror, {1.25f, 0.5f}) == 1);
    CHECK(beside(mirror, {2.25f, 0.5f}) == 0);
  }
  CHECK(at({{"wrapS", clamp}}, {1.25f, 7.5f}) == 1);
}

TEST_CASE("gltf: KHR_texture_transform scales, then turns counter-clockwise, then moves") {
  GltfFile file = gltf_surface(json::object());
  const double right_angle = 1.5707963267948966;
  const json transform = {{"offset", {0.5, 0.25}}, {"rotation", right_angle}, {"scale", {2, 3}}};
  file.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {
      {"index", add_picture(file)}, {"extensions", {{"KHR_texture_transform", transform}}}};
  const LoadedScene loaded = file.load();
  const auto* picture = std::get_if<ImageTexture>(&loaded.scene.textures[0].model);
  REQUIRE(picture);
  // u = 0.1 and v = 0.2 downwards become 0.6 + 0.5 and -0.2 + 0.25.
  const Vec2 uv = picture->uv({0.1f, 0.8f});
  CHECK(uv.x == Approx(1.1));
  CHECK(uv.y == Approx(1 - 0.05));
}

TEST_CASE("gltf: a mask cuts off at its limit, a blend is there by its alpha") {
  GltfFile file = gltf_surface({{"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.25}}}}});
  const auto alpha = [&](const char* mode, double cutoff) {
    file.json["materials"][0]["alphaMode"] = mode;
    file.json["materials"][0]["alphaCutoff"] = cutoff;
    const LoadedScene loaded = file.load();
    const std::uint32_t texture = loaded.scene.bindings[0].alpha;
    return texture == no_texture ? 1 : evaluate(loaded.scene.textures, texture, {}).r;
  };
  CHECK(alpha("OPAQUE", 0.5) == 1);
  CHECK(alpha("BLEND", 0.5) == 0.25f);
  CHECK(alpha("MASK", 0.5) == 0);
  CHECK(alpha("MASK", 0.25) == 1);
}

TEST_CASE("gltf: where a picture's alpha times the factor is below the limit there is a hole") {
  GltfFile file = gltf_surface(json::object());
  const double limit = 0.3;
  file.primitive()["attributes"]["COLOR_0"] =
      file.accessor<float>({1, 1, 1, 0, 1, 1, 1, 1, 1, 1, 1, 0}, "VEC4");
  file.primitive()["attributes"].erase("TEXCOORD_0");
  file.json["materials"][0] = {{"alphaMode", "MASK"},
                               {"alphaCutoff", limit},
                               {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.5}}}}};
  // Without the file's own picture: the alpha of the vertices runs from 0 to 1 along the first edge.
  const LoadedScene loaded = file.load();
  const Mesh& mesh = only_mesh(loaded);
  const auto there_is = [&](float u) {
    const auto& [a, b, c] = mesh.uv_indices[0];
    const Vec2 uv = mesh.uvs[a] * (1 - u) + mesh.uvs[b] * u;
    return evaluate(loaded.scene.textures, loaded.scene.bindings[0].alpha, {.uv = uv}).r;
  };
  CHECK(there_is(0.1f) <= 0);  // Nothing, and not little: a mask cuts.
  CHECK(there_is(0.55f) <= 0);
  CHECK(there_is(0.65f) >= 1);
  CHECK(there_is(0.9f) >= 1);
}

TEST_CASE("gltf: what emits is a light, on both sides where it has two") {
  GltfFile file =
      gltf_surface({{"emissiveFactor", {0.5, 1, 0}},
                    {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}}}}});
  auto light = std::get<MeshLight>(file.load().scene.lights.at(0).source);
  CHECK(light.radiance == Rgb{4, 8, 0});
  CHECK(light.side == EmissionSide::front);
  file.json["materials"][0]["doubleSided"] = true;
  file.json["materials"][0]["emissiveTexture"]["index"] = add_picture(file);
  const LoadedScene loaded = file.load();
  CHECK(loaded.warnings.empty());
  CHECK(loaded.scene.bindings[0].light == 0);
  light = std::get<MeshLight>(loaded.scene.lights.at(0).source);
  CHECK(light.side == EmissionSide::both);
  REQUIRE(light.picture);
  CHECK(light.picture->at(1, 0).b == 1);
  CHECK(file.load({.surfaces_only = true}).scene.lights.empty());
}

TEST_CASE("gltf: a picture of light lies, goes on and has texels as its transform and its sampler say") {
  GltfFile file = gltf_surface({{"emissiveFactor", {1, 1, 1}}});
  file.json["materials"][0]["emissiveTexture"] = {
      {"index", add_picture(file, {{"wrapS", 33071}, {"magFilter", 9728}, {"minFilter", 9728}})},
      {"extensions", {{"KHR_texture_transform", {{"offset", {0.5, 0}}, {"scale", {16, 1}}}}}}};
  const LoadedScene loaded = file.load();
  CHECK(loaded.warnings.empty());
  const auto light = std::get<MeshLight>(loaded.scene.lights.at(0).source);
  CHECK(light.uv({0.25f, 0.5f}) == Vec2{4.5f, 0.5f});
  CHECK(light.wrap == Wrap{WrapMode::clamp, WrapMode::repeat});
  CHECK(light.filter == TextureFilter::nearest);
  REQUIRE(light.picture);
  CHECK(light.picture->width == 2);
}

TEST_CASE("gltf: a surface whose picture of light goes by other coordinates does not emit") {
  GltfFile file = gltf_surface({{"emissiveFactor", {1, 1, 1}}});
  const int picture = add_picture(file);
  file.primitive()["attributes"]["TEXCOORD_1"] = file.accessor<float>({0, 0, 0, 0, 0, 0}, "VEC2");
  file.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = picture;
  file.json["materials"][0]["emissiveTexture"] = {{"index", picture}, {"texCoord", 1}};
  const LoadedScene loaded = file.load();
  CHECK(loaded.scene.lights.empty());
  CHECK(loaded.warnings.back().text() ==
        "test.gltf: /materials/0/emissiveTexture: the light of the surface is left out with its texture");
}

TEST_CASE("gltf: an unlit surface emits its color and reflects nothing") {
  GltfFile file = extended("KHR_materials_unlit", json::object());
  file.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {0.25, 0.5, 1, 1};
  const LoadedScene loaded = file.load();
  CHECK(std::get<Lambert>(loaded.scene.materials[0].model).reflectance == Rgb{0, 0, 0});
  CHECK(std::get<MeshLight>(loaded.scene.lights.at(0).source).radiance == Rgb{0.25f, 0.5f, 1});
}

TEST_CASE("gltf: indices of refraction and specular reflection") {
  CHECK(model_of(extended("KHR_materials_ior", {{"ior", 1.25}})).specular_ior == 1.25f);
  CHECK(model_of(extended("KHR_materials_ior", {{"ior", 0}})).specular_ior == 1000);
  const LoadedScene thin = extended("KHR_materials_ior", {{"ior", 0.5}}).load();
  REQUIRE(thin.warnings.size() == 1);
  CHECK(thin.warnings[0].message ==
        "an index of refraction of 0.5 is rendered as 1; valid are 0, and those from 1");
  GltfFile file =
      extended("KHR_materials_specular", {{"specularFactor", 0.5}, {"specularColorFactor", {1, 0.5, 0.25}}});
  CHECK(model_of(file).specular_weight == 1);  // a metal's stays
  file.json["materials"][0]["pbrMetallicRoughness"]["metallicFactor"] = 0;
  CHECK(model_of(file).specular_weight == 0.5f);
  CHECK(model_of(file).specular_color == Rgb{1, 0.5f, 0.25f});
  // OpenPBR's numbers count for metal, too: the more of it, the nearer are they to 1.
  file.json["materials"][0]["pbrMetallicRoughness"]["metallicFactor"] = 0.5;
  CHECK(model_of(file).specular_weight == 0.75f);
  CHECK(model_of(file).specular_color == Rgb{1, 0.75f, 0.625f});
  file.json["materials"][0]["pbrMetallicRoughness"] = {
      {"metallicFactor", 1}, {"metallicRoughnessTexture", {{"index", add_picture(file)}}}};
  const Scene scene = file.load().scene;
  const auto texture_of = [&](MaterialInput input) {
    const std::vector<TextureUse>& uses = scene.materials[0].textures;
    const auto use =
        std::find_if(uses.begin(), uses.end(), [=](const TextureUse& u) { return u.input == input; });
    REQUIRE(use != uses.end());
    return use->texture;
  };
  for (const auto& [input, value] : {std::pair{MaterialInput::specular_weight, Rgb{0.5f, 0.5f, 0.5f}},
                                     {MaterialInput::specular_color, Rgb{1, 0.5f, 0.25f}}}) {
    const auto& spared = std::get<MixTexture>(scene.textures.at(texture_of(input)).model);
    CHECK(std::get<ConstantTexture>(scene.textures.at(spared.first).model).value == value);
    CHECK(std::get<ConstantTexture>(scene.textures.at(spared.second).model).value == white);
    CHECK(spared.amount == texture_of(MaterialInput::base_metalness));
  }
}

TEST_CASE("gltf: the specular factor does not change how a body refracts") {
  GltfFile file = extended("KHR_materials_specular", {{"specularFactor", 0.5}});
  file.json["materials"][0]["pbrMetallicRoughness"]["metallicFactor"] = 0;
  auto& extensions = file.json["materials"][0]["extensions"];
  extensions["KHR_materials_transmission"] = {{"transmissionFactor", 1}};
  CHECK(model_of(file).specular_weight == 0.5f);  // A sheet refracts nothing.
  extensions["KHR_materials_volume"] = {{"thicknessFactor", 1}};
  const LoadedScene loaded = file.load();
  CHECK(std::get<Principled>(loaded.scene.materials[0].model).specular_weight == 1);
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].message.starts_with(
      "the specular factor of a body that light goes through is left out"));
}

TEST_CASE("gltf: transmission is that of a sheet or, with a thickness, of a body that absorbs") {
  GltfFile file = extended("KHR_materials_transmission", {{"transmissionFactor", 0.75}});
  file.json["materials"][0]["pbrMetallicRoughness"] = {{"baseColorFactor", {1, 0.5, 0.25, 1}},
                                                       {"metallicFactor", 0}};
  const Principled sheet = model_of(file);
  CHECK(sheet.transmission_weight == 0.75f);
  CHECK(sheet.transmission_color == Rgb{1, 0.5f, 0.25f});
  CHECK(sheet.geometry_thin_walled);
  file.json["materials"][0]["extensions"]["KHR_materials_volume"] = {
      {"thicknessFactor", 1}, {"attenuationDistance", 2}, {"attenuationColor", {1, 0.5, 0.25}}};
  CHECK_FALSE(model_of(file).geometry_thin_walled);
  const Rgb absorption = file.load().scene.materials[0].interior.absorption;
  CHECK(absorption.r == 0);
  CHECK(exp_of(-absorption.g * 2) == Approx(0.5));
  CHECK(exp_of(-absorption.b * 2) == Approx(0.25));
  CHECK_FALSE(file.load().scene.materials[0].interior.is_clear);
  file.json["materials"][0]["extensions"]["KHR_materials_volume"] = {{"thicknessFactor", 1}};
  CHECK(file.load().scene.materials[0].interior.is_clear);
  // A texture may say that what is metal by its factor is none.
  file.json["materials"][0]["extensions"]["KHR_materials_volume"]["attenuationDistance"] = 2;
  file.json["materials"][0]["extensions"]["KHR_materials_volume"]["attenuationColor"] = {0.5, 1, 1};
  file.json["materials"][0]["pbrMetallicRoughness"] = {
      {"metallicRoughnessTexture", {{"index", add_picture(file)}}}};
  CHECK(exp_of(-file.load().scene.materials[0].interior.absorption.r * 2) == Approx(0.5));
}

TEST_CASE("gltf: a coat has an index of 1.5 and its own roughness") {
  const Principled coated = model_of(
      extended("KHR_materials_clearcoat", {{"clearcoatFactor", 0.5}, {"clearcoatRoughnessFactor", 0.25}}));
  CHECK(coated.coat_weight == 0.5f);
  CHECK(coated.coat_roughness == 0.25f);
  CHECK(coated.coat_ior == 1.5f);
  CHECK(coated.coat_darkening == 0);
  // The base has the reflection against air that it has without a coat; OpenPBR's index is that to the coat.
  CHECK(coated.specular_ior == 1.5f * 1.25f);
  GltfFile whole = extended("KHR_materials_clearcoat", {{"clearcoatFactor", 1}});
  CHECK(model_of(whole).specular_ior == 2.25f);
  whole.json["materials"][0]["extensions"]["KHR_materials_transmission"] = {{"transmissionFactor", 1}};
  CHECK(model_of(whole).specular_ior == 1.5f);  // Light goes through by it.
}

TEST_CASE("gltf: sheen is fuzz whose weight is its brightest channel") {
  const Principled cloth = model_of(extended(
      "KHR_materials_sheen", {{"sheenColorFactor", {0.5, 0.25, 0}}, {"sheenRoughnessFactor", 0.75}}));
  CHECK(cloth.fuzz_weight == 0.5f);
  CHECK(cloth.fuzz_color == Rgb{1, 0.5f, 0});
  CHECK(cloth.fuzz_roughness == 0.75f);
}

TEST_CASE("gltf: where the texture of sheen is dark, the fuzz hides nothing") {
  GltfFile file = extended("KHR_materials_sheen", {{"sheenColorFactor", {0.5, 0.25, 0}}});
  // Red 188 on the left and 0 on the right.
  file.json["materials"][0]["extensions"]["KHR_materials_sheen"]["sheenColorTexture"] = {
      {"index", add_picture(file)}};
  const LoadedScene loaded = file.load();
  const auto fuzz_at = [&](const Scene& scene, Vec2 uv) {
    return std::get<Principled>(textured_model(scene.materials[0], scene.textures, {.uv = uv}));
  };
  const Principled bright = fuzz_at(loaded.scene, left), dark = fuzz_at(loaded.scene, right);
  CHECK(bright.fuzz_weight == Approx(0.5 * 0.50288654).margin(1e-5));
  CHECK(bright.fuzz_color.r == 1);
  CHECK(dark.fuzz_weight == Approx(max_component(input_at(loaded, MaterialInput::fuzz_color, right))));
  CHECK(dark.fuzz_weight < bright.fuzz_weight / 2);
}

TEST_CASE("gltf: a normal map is scaled, and turned where texture coordinates are mirrored") {
  GltfFile file = gltf_surface(json::object());
  file.json["materials"][0]["normalTexture"] = {{"index", add_picture(file)}, {"scale", 0.5}};
  const auto slope = [&] {
    const LoadedScene loaded = file.load();
    CHECK(loaded.warnings.empty());
    const std::uint32_t map = loaded.scene.materials[0].normal_map;
    return evaluate(loaded.scene.textures, map, {.uv = left});
  };
  // 188 51 0: x = 2 (188 / 255) - 1, halved, and so on; z stays.
  CHECK(slope().r == Approx(0.5 + 0.5 * (188.0 / 255 - 0.5)));
  CHECK(slope().g == Approx(0.5 + 0.5 * (51.0 / 255 - 0.5)));
  CHECK(slope().b == Approx(0).margin(1e-6));
  const int tangents = file.accessor<float>({1, 0, 0, -1, 1, 0, 0, -1, 1, 0, 0, -1}, "VEC4");
  file.primitive()["attributes"]["TANGENT"] = tangents;
  CHECK(slope().g == Approx(0.5 - 0.5 * (51.0 / 255 - 0.5)));
  file.json["nodes"][0]["scale"] = {-1, 1, 1};
  CHECK(slope().g == Approx(0.5 + 0.5 * (51.0 / 255 - 0.5)));
  file.primitive()["attributes"].erase("TANGENT");
  CHECK(slope().g == Approx(0.5 - 0.5 * (51.0 / 255 - 0.5)));
}

TEST_CASE("gltf: tangents that are not those of the texture coordinates are named where that matters") {
  GltfFile file = gltf_surface(json::object());
  file.json["materials"][0]["normalTexture"] = {{"index", add_picture(file)}};
  const auto warnings = [&](const std::vector<float>& tangents) {
    file.primitive()["attributes"]["TANGENT"] = file.accessor<float>(tangents, "VEC4");
    return file.load().warnings;
  };
  const float c = 0.8f, s = 0.6f;  // 37 degrees.
  CHECK(warnings({1, 0, 0, 1, 0.9f, 0.43f, 0, 1, 1, 0, 0, 1}).empty());
  for (const auto& turned : {std::pair(c, s), std::pair(-1.0f, 0.0f), std::pair(0.0f, 0.0f)}) {
    const auto [x, y] = turned;
    const auto found = warnings({x, y, 0, 1, x, y, 0, 1, x, y, 0, 1});
    REQUIRE(found.size() == 1);
    CHECK(found[0].text() ==
          "test.gltf: /meshes/0/primitives/0/attributes/TANGENT: these tangents are not those of "
          "the texture coordinates, by which normal maps and brushed facets go");
  }
  // Other coordinates may grow elsewhere; mirrored ones against x.
  nlohmann::json& attributes = file.primitive()["attributes"];
  attributes["TEXCOORD_1"] = file.accessor<float>({0, 0, 0, 1, 1, 0}, "VEC2");
  CHECK(warnings({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}).empty());
  attributes["TEXCOORD_0"] = file.accessor<float>({1, 1, 0, 1, 1, 0}, "VEC2");
  CHECK(warnings({-1, 0, 0, -1, -1, 0, 0, -1, -1, 0, 0, -1}).empty());
  CHECK(warnings({1, 0, 0, -1, 1, 0, 0, -1, 1, 0, 0, -1}).size() == 1);
  file.json["materials"][0].erase("normalTexture");
  CHECK(warnings({0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1}).empty());
}

TEST_CASE("gltf: specular and glossiness are a dielectric of such a reflection") {
  const Principled model = model_of(extended(
      "KHR_materials_pbrSpecularGlossiness",
      {{"diffuseFactor", {0.5, 1, 0, 1}}, {"specularFactor", {0.25, 0.125, 0}}, {"glossinessFactor", 0.75}}));
  CHECK(model.base_color == Rgb{0.375f, 0.75f, 0});
  CHECK(model.base_metalness == 0);
  CHECK(model.specular_roughness == 0.25f);
  CHECK(model.specular_ior == 3);  // (1.5 / 0.5)
  CHECK(model.specular_color == Rgb{1, 0.5f, 0});
}

TEST_CASE("gltf: a picture in WebP is shown in place of the one for readers without it") {
  // As libwebp writes it without loss: 255 51 0, and 0 102 255 with an alpha of 128.
  const std::string bytes{
      "\x52\x49\x46\x46\x20\x00\x00\x00\x57\x45\x42\x50\x56\x50\x38\x4c\x14\x00\x00\x00"
      "\x2f\x01\x00\x00\x10\x0f\xd0\x99\xfd\x9f\xff\x07\xfe\x47\x85\x0a\x44\xf4\x3f\x00",
      40};
  GltfFile file = gltf_surface({{"alphaMode", "BLEND"}});
  const int webp = file.add("images", {{"bufferView", file.view(bytes)}, {"mimeType", "image/webp"}});
  const int texture = add_picture(file);
  file.json["extensionsUsed"] = {"EXT_texture_webp"};
  json& source = file.json["textures"][std::size_t(texture)];
  source["extensions"]["EXT_texture_webp"]["source"] = webp;
  file.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", texture}};
  const auto check_shown = [&] {
    const LoadedScene loaded = file.load();
    CHECK(loaded.warnings.empty());
    CHECK(input_at(loaded, MaterialInput::reflectance, left).r == 1);
    CHECK(input_at(loaded, MaterialInput::reflectance, left).g == Approx(0.0331).epsilon(1e-3));
    CHECK(input_at(loaded, MaterialInput::reflectance, right).b == 1);
    const std::uint32_t alpha = loaded.scene.bindings[0].alpha;
    CHECK(evaluate(loaded.scene.textures, alpha, {.uv = right}).r == Approx(128.0 / 255));
  };
  check_shown();
  source.erase("source");
  check_shown();
  source["extensions"]["EXT_texture_webp"]["source"] = 7;
  CHECK(file.error().starts_with("test.gltf: /textures/0/extensions/EXT_texture_webp/source: "));
}

TEST_CASE("gltf: what is not rendered is named") {
  GltfFile file = gltf_surface({{"occlusionTexture", {{"index", 0}}}, {"name", "wall"}});
  file.json["textures"] = json::array({json::object()});
  CHECK(file.load().summary.notes ==
        std::vector<std::string>{"occlusion textures are left out, for light is traced: that of \"wall\""});
  file.json["extensionsUsed"] = {"KHR_materials_dispersion"};
  CHECK(file.warning() ==
        "test.gltf: /extensionsUsed/0: the extension KHR_materials_dispersion is not rendered");
  file.json["extensionsRequired"] = {"KHR_texture_basisu"};
  CHECK(file.error() ==
        "test.gltf: /extensionsRequired/0: the extension KHR_texture_basisu is not rendered, "
        "and the file cannot be shown without it");
}

}  // namespace twinray::test

// SPDX-License-Identifier: Apache-2.0
// Pictures of films, fuzz and specular reflection, written as glTF and read again.
#include "core/textured_material.h"
#include "tests/io/gltf/surface.h"
#include "tests/io/gltf/written.h"
#include "tests/support/catch.h"
#include "tests/support/round_trip.h"

namespace twinray::test {

TEST_CASE("written gltf: pictures of a film come back in their channels") {
  Scene scene = scene_of(triangle(), Principled{.thin_film_weight = 1, .thin_film_ior = 1.5f});
  scene.textures = {{"", ImageTexture{picture(), WrapMode::repeat, TextureFilter::nearest, {}}},
                    {"", ScaleTexture{0, 0}},
                    {"", ConstantTexture{{0.3f, 0, 0}}},
                    {"", ConstantTexture{{1.7f, 0, 0}}},
                    {"", MixTexture{2, 3, 0}}};
  Material& film = scene.materials[0];
  film.textures = {{MaterialInput::thin_film_weight, 0}, {MaterialInput::thin_film_thickness, 1}};
  const std::vector<std::string> cut = {
      "what is above 1 micrometer of a thin film's thickness is written as 1"};
  for (const std::uint32_t thickness : {0u, 1u, 4u}) {
    CAPTURE(thickness);
    film.textures[1].texture = thickness;
    const RoundTrip trip = round_trip(scene, "a.gltf");
    CHECK(trip.warnings == (thickness == 1 ? cut : std::vector<std::string>{}));
    for (const Vec2 uv : {Vec2{0.1f, 0.9f}, {0.9f, 0.9f}, {0.4f, 0.2f}}) {
      const auto a = std::get<Principled>(textured_model(film, scene.textures, {.uv = uv}));
      const auto b =
          std::get<Principled>(textured_model(only_material(trip), trip.scene.textures, {.uv = uv}));
      CHECK(b.thin_film_weight == Approx(a.thin_film_weight).margin(0.003));
      CHECK(b.thin_film_thickness == Approx(a.thin_film_thickness).margin(0.004));
      CHECK(b.thin_film_ior == 1.5f);
    }
  }
}

TEST_CASE("written gltf: what the reader gives metal of specular reflection is not given once more") {
  GltfFile file =
      extended("KHR_materials_specular", {{"specularFactor", 0.5}, {"specularColorFactor", {1, 0.5, 0.25}}});
  auto& material = file.json["materials"][0];
  const int added = add_picture(file);
  for (const bool has_metal_texture : {false, true})
    for (const bool has_specular_texture : {false, true}) {
      CAPTURE(has_metal_texture, has_specular_texture);
      material["pbrMetallicRoughness"] = {{"metallicFactor", has_metal_texture ? 0.75 : 0.25}};
      if (has_metal_texture)
        material["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", added}};
      auto& specular = material["extensions"]["KHR_materials_specular"];
      specular.erase("specularColorTexture");
      if (has_specular_texture) specular["specularColorTexture"] = {{"index", added}};
      const LoadedScene loaded = file.load();
      const RoundTrip trip = round_trip(loaded.scene, "a.gltf");
      CHECK(trip.warnings.empty());
      for (const Vec2 uv : {left, right}) {
        const auto a = std::get<Principled>(
            textured_model(loaded.scene.materials[0], loaded.scene.textures, {.uv = uv}));
        const auto b =
            std::get<Principled>(textured_model(only_material(trip), trip.scene.textures, {.uv = uv}));
        CHECK(b.specular_weight == Approx(a.specular_weight).margin(0.005));
        CHECK(b.specular_color.g == Approx(a.specular_color.g).margin(0.005));
        CHECK(b.specular_color.b == Approx(a.specular_color.b).margin(0.005));
      }
    }
}

TEST_CASE("written gltf: a picture of fuzz that also says how much there is comes back") {
  Scene scene = scene_of(triangle(), Principled{.fuzz_weight = 0.75f, .fuzz_roughness = 0.5f});
  scene.textures = {{"", ImageTexture{picture(), WrapMode::repeat, TextureFilter::nearest, {}}}};
  for (const InputMeaning meaning : {InputMeaning::value, InputMeaning::weighted_color}) {
    scene.materials[0].textures = {{MaterialInput::fuzz_color, 0, meaning}};
    const RoundTrip trip = round_trip(scene, "a.gltf");
    CHECK(trip.warnings.empty());
    for (const Vec2 uv : {Vec2{0.1f, 0.9f}, {0.9f, 0.9f}, {0.4f, 0.2f}}) {
      const auto a = std::get<Principled>(textured_model(scene.materials[0], scene.textures, {.uv = uv}));
      const auto b =
          std::get<Principled>(textured_model(only_material(trip), trip.scene.textures, {.uv = uv}));
      const Rgb wanted = a.fuzz_color * a.fuzz_weight, read = b.fuzz_color * b.fuzz_weight;
      CHECK(read.r == Approx(wanted.r).margin(0.005));
      CHECK(read.g == Approx(wanted.g).margin(0.005));
      CHECK(read.b == Approx(wanted.b).margin(0.005));
      CHECK(b.fuzz_weight == Approx(max_component(wanted)).margin(0.005));
    }
  }
}

}  // namespace twinray::test

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

TEST_CASE("written gltf: textures that need no coordinates come back on a mesh that has none") {
  Mesh mesh = triangle();
  mesh.uvs.clear();
  mesh.uv_indices.clear();
  Scene scene = scene_of(mesh, Principled{});
  scene.textures = {{"", ConstantTexture{{0.2f, 0.4f, 0.6f}}},
                    {"", ConstantTexture{{0.5f, 0.5f, 0.5f}}},
                    {"", ScaleTexture{0, 1}}};
  scene.materials[0].textures = {{MaterialInput::reflectance, 2}, {MaterialInput::roughness, 1}};
  const RoundTrip trip = round_trip(scene, "a.glb");
  CHECK(trip.warnings.empty());
  const auto surface = std::get<Principled>(textured_model(only_material(trip), trip.scene.textures, {}));
  CHECK(surface.base_color.r == Approx(0.1f).margin(0.004));
  CHECK(surface.base_color.g == Approx(0.2f).margin(0.004));
  CHECK(surface.base_color.b == Approx(0.3f).margin(0.004));
  CHECK(surface.specular_roughness == Approx(0.5f).margin(0.004));
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

namespace {

const std::string dark_fuzz = "dark fuzz of a material hides less of what is below it";

}  // namespace

TEST_CASE("written gltf: dark fuzz reflects as before, and that it hides less is told") {
  for (const Rgb& color : {Rgb{0.5f, 0.25f, 0.125f}, Rgb{1, 0.5f, 0.25f}, Rgb{}}) {
    Principled fuzzy{.fuzz_weight = 0.5f, .fuzz_roughness = 0.5f};
    fuzzy.fuzz_color = color;
    const RoundTrip trip = round_trip(scene_of(triangle(), fuzzy), "a.gltf");
    const float most = max_component(color);
    CHECK(trip.warnings == std::vector<std::string>(most < 1 ? 1 : 0, dark_fuzz));
    const auto& read = std::get<Principled>(only_material(trip).model);
    CHECK(read.fuzz_weight == 0.5f * most);
    if (most > 0) CHECK(read.fuzz_color == color / most);
  }
}

TEST_CASE("written gltf: a picture of fuzz that also says how much there is comes back") {
  Principled fuzzy{.fuzz_weight = 0.75f, .fuzz_roughness = 0.5f};
  fuzzy.fuzz_color = {0.25f, 0.125f, 0.5f};  // As readers take it from the picture, which it stands for.
  Scene scene = scene_of(triangle(), fuzzy);
  scene.textures = {{"", ImageTexture{picture(), WrapMode::repeat, TextureFilter::nearest, {}}}};
  for (const InputMeaning meaning : {InputMeaning::value, InputMeaning::weighted_color}) {
    scene.materials[0].textures = {{MaterialInput::fuzz_color, 0, meaning}};
    const RoundTrip trip = round_trip(scene, "a.gltf");
    const bool is_dark = meaning == InputMeaning::value;
    CHECK(trip.warnings == std::vector<std::string>(is_dark ? 1 : 0, dark_fuzz));
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

namespace {

/// A triangle of this material, and two pictures.
Scene scene_with_pictures(const Principled& model, std::vector<TextureUse> uses) {
  Scene scene = scene_of(triangle(), model);
  scene.textures = {{"", ImageTexture{test::picture(), WrapMode::repeat, TextureFilter::nearest, {}}},
                    {"", ScaleTexture{0, 0}}};
  scene.materials[0].textures = std::move(uses);
  return scene;
}

Principled read_at(const Scene& scene, const Material& material, Vec2 uv) {
  return std::get<Principled>(textured_model(material, scene.textures, {.uv = uv}));
}

}  // namespace

TEST_CASE("written gltf: the weight of a base is a factor of the picture of its color") {
  const Scene scene =
      scene_with_pictures({.base_weight = 0.5f, .specular_weight = 0}, {{MaterialInput::reflectance, 0}});
  const RoundTrip trip = round_trip(scene, "a.gltf");
  CHECK(trip.warnings.empty());
  for (const Vec2 uv : {Vec2{0.1f, 0.9f}, {0.9f, 0.9f}, {0.4f, 0.2f}}) {
    const Principled a = read_at(scene, scene.materials[0], uv);
    const Principled b = read_at(trip.scene, only_material(trip), uv);
    CHECK(b.base_color.r * b.base_weight == Approx(a.base_color.r * 0.5f).margin(0.004));
    CHECK(b.base_color.b * b.base_weight == Approx(a.base_color.b * 0.5f).margin(0.004));
  }
}

TEST_CASE(
    "written gltf: the color of what light goes through is that of the base, and what changes is named") {
  const Principled clear{
      .base_color = {0.5f, 0.25f, 0.125f}, .transmission_weight = 1, .geometry_thin_walled = true};
  Principled half = clear, partly_metal = clear, metal = clear;
  half.transmission_weight = 0.5f;
  partly_metal.base_metalness = 0.5f, metal.base_metalness = 1;
  const auto color = [](const Principled& model, std::vector<TextureUse> uses,
                        const std::vector<std::string>& lost) {
    const Scene scene = scene_with_pictures(model, std::move(uses));
    const RoundTrip trip = round_trip(scene, "a.gltf");
    CHECK(trip.warnings == lost);
    const Vec2 uv{0.4f, 0.2f};
    const Principled read = read_at(trip.scene, only_material(trip), uv);
    const Principled wanted = read_at(scene, scene.materials[0], uv);
    CHECK(read.transmission_color == read.base_color);
    return std::pair{read.base_color.b, wanted.transmission_color.b};
  };
  const std::string lost = "which is that of the clear part, of a material is left out";
  const std::string diffuse = "the color of the diffuse part, " + lost;
  const std::string of_metal = "the color of the metal, " + lost;
  const TextureUse base{MaterialInput::reflectance, 0}, tint{MaterialInput::transmission_color, 1};
  const auto check = [&](const Principled& model, const std::vector<TextureUse>& uses,
                         const std::vector<std::string>& named) {
    const auto [read, wanted] = color(model, uses, named);
    CHECK(read == Approx(wanted).margin(0.004));
  };
  check(clear, {}, {});
  check(clear, {base}, {});
  check(clear, {tint}, {});
  check(clear, {base, tint}, {});
  check(half, {base}, {diffuse});
  check(half, {base, tint}, {diffuse});
  check(half, {base, {MaterialInput::transmission_color, 0}}, {});
  check(clear, {{MaterialInput::transmission_weight, 0}}, {diffuse});
  check(partly_metal, {}, {of_metal});
  check(clear, {{MaterialInput::base_metalness, 0}}, {of_metal});
  CHECK(color(metal, {}, {}).first == 0.125f);  // Nothing goes through it.
}

TEST_CASE("written gltf: a specular reflection that metal has, too, is named") {
  const std::vector<std::string> lost = {"the metal's specular color of a material is left out"};
  const auto warnings = [](const Principled& model, std::vector<TextureUse> uses) {
    return round_trip(scene_with_pictures(model, std::move(uses)), "a.gltf").warnings;
  };
  const TextureUse metalness{MaterialInput::base_metalness, 0}, weight{MaterialInput::specular_weight, 1};
  CHECK(warnings({.specular_weight = 0.2f}, {metalness}) == lost);
  CHECK(warnings({.specular_color = {1, 1, 0.5f}}, {metalness}) == lost);
  CHECK(warnings({.base_metalness = 0.5f, .specular_weight = 0.2f}, {}) == lost);
  CHECK(warnings({.base_metalness = 0.5f, .specular_color = {1, 1, 0.25f}}, {}) == lost);
  CHECK(warnings({.base_metalness = 0.5f}, {weight}) == lost);
  CHECK(warnings({.base_metalness = 1}, {weight}) == lost);
  CHECK(warnings({.specular_weight = 0.2f}, {}).empty());
  CHECK(warnings({}, {weight}).empty());
  CHECK(warnings({}, {metalness}).empty());
  CHECK(warnings({.base_metalness = 0.5f, .specular_weight = 0.75f}, {}).empty());
}

}  // namespace twinray::test

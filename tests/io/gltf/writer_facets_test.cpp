// SPDX-License-Identifier: Apache-2.0
// The direction of facets, written as glTF and read again.
#include "core/textured_material.h"
#include "tests/io/gltf/written.h"
#include "tests/support/catch.h"
#include "tests/support/round_trip.h"

namespace twinray::test {

TEST_CASE("written gltf: facets of a direction come back, turned, by pictures, and where they lie mirrored") {
  Principled brushed{.base_metalness = 1, .specular_roughness = 0.5f, .specular_roughness_anisotropy = 0.5f};
  Scene scene = scene_of(triangle(), brushed);
  scene.textures = {{"", ImageTexture{picture(), WrapMode::repeat, TextureFilter::nearest, {}}},
                    {"", ConstantTexture{{0.25f, 0, 0}}}};
  Material& metal = scene.materials[0];
  const auto check_round_trip = [&] {
    const RoundTrip trip = round_trip(scene, "a.gltf");
    CHECK(trip.warnings.empty());
    const Material& read = only_material(trip);
    CHECK(read.tangent_degrees == Approx(metal.tangent_degrees));
    CHECK((read.tangent_map == no_texture) == (metal.tangent_map == no_texture));
    if (metal.tangent_map != no_texture)
      for (const Vec2 uv : {Vec2{0.1f, 0.9f}, {0.9f, 0.9f}, {0.4f, 0.2f}}) {
        const Rgb wanted = evaluate(scene.textures, metal.tangent_map, {.uv = uv});
        const Rgb found = evaluate(trip.scene.textures, read.tangent_map, {.uv = uv});
        CHECK(found.r == Approx(wanted.r).margin(0.5 / 255 + 1e-6));
        CHECK(found.g == Approx(wanted.g).margin(0.5 / 255 + 1e-6));
      }
    for (const Vec2 uv : {Vec2{0.1f, 0.9f}, {0.9f, 0.9f}, {0.4f, 0.2f}}) {
      const auto a = std::get<Principled>(textured_model(metal, scene.textures, {.uv = uv}));
      const auto b = std::get<Principled>(textured_model(read, trip.scene.textures, {.uv = uv}));
      CHECK(b.specular_roughness == Approx(a.specular_roughness).margin(0.003));
      CHECK(b.specular_roughness_anisotropy == Approx(a.specular_roughness_anisotropy).margin(0.006));
    }
  };
  metal.tangent_degrees = -50;
  check_round_trip();
  metal.tangent_map = 0;
  check_round_trip();
  for (const std::uint32_t widened_by : {0u, 1u}) {
    metal.textures = {{MaterialInput::specular_roughness_anisotropy, widened_by, InputMeaning::widening}};
    check_round_trip();
    metal.tangent_map = no_texture;
  }
  metal.textures.push_back({MaterialInput::roughness, 0});
  check_round_trip();
  // A picture of a strength has a direction in the file, too: that of the coordinates.
  metal.textures[0].texture = 0;
  const RoundTrip trip = round_trip(scene, "a.gltf");
  const Rgb direction = evaluate(trip.scene.textures, only_material(trip).tangent_map, {.uv = {0.4f, 0.2f}});
  CHECK(direction.r == 1);
  CHECK(direction.g == Approx(0.5).margin(0.5 / 255 + 1e-6));
  // Mirrored, both are turned around in the file, and the reader turns them back.
  Mesh mirrored = triangle();
  mirrored.uvs = {{0, 0}, {-1, 0}, {-0.25f, 1}};
  scene.geometry = std::make_shared<const Geometry>(std::vector<Shape>{mirrored});
  metal.tangent_map = 0;
  check_round_trip();
}

TEST_CASE("written gltf: facets that are wider across than along are turned") {
  for (const auto& [degrees, expected] : {std::pair{0.0f, 90.0f}, {30.0f, -60.0f}, {-100.0f, -10.0f}}) {
    Scene scene = scene_of(triangle(), Conductor{.roughness = {0.125f, 0.5f}});
    scene.materials[0].tangent_degrees = degrees;
    const RoundTrip trip = round_trip(scene, "a.gltf");
    CHECK(trip.warnings.size() == 1);  // A metal of its color.
    CHECK(only_material(trip).tangent_degrees == Approx(expected));
    CHECK(std::get<Principled>(only_material(trip).model).specular_roughness_anisotropy == Approx(0.75));
  }
}

TEST_CASE("written gltf: facets of uneven widths beside a picture of the roughness are even, and are named") {
  Scene scene = scene_of(triangle(), Principled{.specular_roughness_anisotropy = 0.75f});
  scene.textures = {{"", ImageTexture{picture(), WrapMode::repeat, TextureFilter::nearest, {}}}};
  scene.materials[0].textures = {{MaterialInput::roughness, 0}};
  const RoundTrip trip = round_trip(scene, "a.gltf");
  CHECK(trip.warnings == std::vector<std::string>{
                             "the anisotropy beside a texture of the roughness of a material is left out"});
  const auto read =
      std::get<Principled>(textured_model(only_material(trip), trip.scene.textures, {.uv = {0.4f, 0.2f}}));
  CHECK(read.specular_roughness_anisotropy == 0);
  CHECK(read.specular_roughness == Approx(evaluate(scene.textures, 0, {.uv = {0.4f, 0.2f}}).r).margin(0.003));
}

}  // namespace twinray::test

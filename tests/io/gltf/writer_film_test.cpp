// SPDX-License-Identifier: Apache-2.0
// Pictures of films, written as glTF and read again.
#include "core/textured_material.h"
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

}  // namespace twinray::test

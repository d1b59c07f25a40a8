// SPDX-License-Identifier: Apache-2.0
// OpenPBR's materials, written in pbrt's format and read again.
#include <algorithm>
#include <cmath>

#include "core/textured_material.h"
#include "tests/support/catch.h"
#include "tests/support/round_trip.h"

namespace twinray::test {
namespace {

/// Of a texture's value after a product and a root.
constexpr double root_rounding = 1e-5;

/// A triangle of this material; texture 0 is a picture of some numbers that no byte has.
Scene scene_with_picture(const Principled& model) {
  Mesh mesh{.name = "triangle", .positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}}};
  mesh.uvs = {{0, 0}, {1, 0}, {0, 1}};
  mesh.uv_indices = mesh.triangles;
  Scene scene = scene_of(mesh, model);
  Image image(3, 2);
  for (std::size_t i = 0; i < 6; ++i)
    image.pixels[i] = {0.1f * float(i) + 0.02f, 0.05f * float(i) + 0.01f, 0.9f - 0.1f * float(i)};
  const auto picture = std::make_shared<const MipMap>(std::move(image));
  scene.textures = {{"", ImageTexture{picture, WrapMode::repeat, TextureFilter::nearest, {}}}};
  return scene;
}

constexpr Vec2 some_points[] = {{0.1f, 0.9f}, {0.9f, 0.9f}, {0.4f, 0.2f}};

}  // namespace

TEST_CASE("written pbrt: the weight of a base is a factor of the picture of its color") {
  Scene scene = scene_with_picture({.base_weight = 0.5f, .specular_weight = 0});
  scene.materials[0].textures = {{MaterialInput::reflectance, 0}};
  const RoundTrip diffuse = round_trip(scene, "a.pbrt");
  std::get<Principled>(scene.materials[0].model).base_metalness = 1;
  const RoundTrip metal = round_trip(scene, "a.pbrt");
  for (const Vec2 uv : some_points) {
    const Rgb wanted = evaluate(scene.textures, 0, {.uv = uv}) * 0.5f;
    const auto matte =
        std::get<Lambert>(textured_model(only_material(diffuse), diffuse.scene.textures, {.uv = uv}));
    CHECK(matte.reflectance == wanted);
    const auto shiny =
        std::get<Conductor>(textured_model(only_material(metal), metal.scene.textures, {.uv = uv}));
    CHECK(shiny.k.r == Approx(metal_k(wanted).r).epsilon(root_rounding));
    CHECK(shiny.k.b == Approx(metal_k(wanted).b).epsilon(root_rounding));
  }
}

TEST_CASE("written pbrt: facets beside a picture of the roughness are as uneven as they were") {
  Scene scene = scene_with_picture({.base_metalness = 1, .specular_roughness_anisotropy = 0.75f});
  scene.materials[0].textures = {{MaterialInput::roughness, 0}};
  const RoundTrip metal = round_trip(scene, "a.pbrt");
  std::get<Principled>(scene.materials[0].model).base_metalness = 0;
  std::get<Principled>(scene.materials[0].model).coat_weight = 1;
  scene.materials[0].textures[0].input = MaterialInput::coat_roughness;
  const RoundTrip coated = round_trip(scene, "a.pbrt");
  for (const Vec2 uv : some_points) {
    const float r = evaluate(scene.textures, 0, {.uv = uv}).r;
    const float along = r * r * std::sqrt(2 / (1 + 0.25f * 0.25f));
    const auto facets =
        std::get<Conductor>(textured_model(only_material(metal), metal.scene.textures, {.uv = uv})).roughness;
    CHECK(facets.x == Approx(along).epsilon(root_rounding));
    CHECK(facets.y == Approx(0.25f * along).epsilon(root_rounding));
    const auto coat =
        std::get<CoatedDiffuse>(textured_model(only_material(coated), coated.scene.textures, {.uv = uv}));
    CHECK(coat.roughness.x == Approx(r * r).epsilon(root_rounding));
    CHECK(coat.roughness.y == Approx(r * r).epsilon(root_rounding));
  }
}

TEST_CASE("written pbrt: the tint of what light goes through is named") {
  const auto names_color = [](const Principled& model) {
    const auto warnings = round_trip(scene_with_picture(model), "a.pbrt").warnings;
    return std::count(warnings.begin(), warnings.end(),
                      "the color of a material of the type openpbr is left out") == 1;
  };
  CHECK(names_color({.transmission_weight = 1, .transmission_color = {0.9f, 0.1f, 0.1f}}));
  CHECK(names_color(
      {.transmission_weight = 1, .transmission_color = {0.9f, 0.1f, 0.1f}, .geometry_thin_walled = true}));
  CHECK_FALSE(names_color({.transmission_weight = 1}));
  CHECK_FALSE(
      names_color({.transmission_weight = 1, .transmission_color = {0.9f, 1, 1}, .transmission_depth = 1}));
}

}  // namespace twinray::test

// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/writer_texture.h"

#include <algorithm>
#include <string>
#include <vector>

#include "core/alpha_test.h"
#include "core/scene_textures.h"
#include "core/textured_material.h"
#include "tests/io/pbrt/written_parts.h"
#include "tests/support/catch.h"
#include "tests/support/round_trip.h"

namespace twinray::test {

TEST_CASE("written pbrt: textures of each class give the same values, as colors and as numbers") {
  Scene scene = scene_of(mapped_triangle(), CoatedDiffuse{});
  const UvTransform uv{{{2, 0, 0.25f}, {0, -3, 0.5f}}};
  const PointTransform turned{{{0, 2, 0, 0.5f}, {-2, 0, 0, 0.25f}, {0, 0, 2, -1}}};
  scene.textures = {
      {"picture", ImageTexture{odd_picture(), WrapMode::clamp, TextureFilter::bilinear, uv}},
      {"half", ConstantTexture{{0.5f, 0.5f, 0.5f}}},
      {"tint", ConstantTexture{{0.5f, 0.25f, 1}}},
      {"halved", ScaleTexture{1, 0}},
      {"mixed", MixTexture{0, 2, 3}},
      {"board", CheckerboardTexture{4, 2, uv}},
      {"points", ImageTexture{odd_picture(), WrapMode::repeat, TextureFilter::nearest, {}}},
      {"black beside", ImageTexture{odd_picture(), WrapMode::black, TextureFilter::bilinear, {}}},
      {"tinted", ScaleTexture{6, 2}},
      {"cubes", CubesTexture{4, 2}},
      {"dots", DotsTexture{4, 2, uv}},
      {"corners", BilinearTexture{{1, 0, 0}, {0, 0.5f, 0}, {0, 0, 1}, {0.25f, 1, 0.5f}, uv}},
      {"leaning", DirectionMixTexture{0, 2, normalize(Vec3{1, 2, 3})}},
      {"clouds", NoiseTexture{NoisePattern::fbm, {4, 0.75f}}},
      {"wrinkles", NoiseTexture{.pattern = NoisePattern::wrinkled}},
      {"waves", NoiseTexture{.pattern = NoisePattern::windy}},
      {"there", PlacedTexture{13, TexturePlacement::space, turned}},
      {"on a plane", PlacedTexture{0, TexturePlacement::planar, turned}},
      {"plain", ImageTexture{odd_picture(), WrapMode::repeat, TextureFilter::bilinear, {}}},
      {"around", PlacedTexture{18, TexturePlacement::spherical, turned}},
      {"about", PlacedTexture{18, TexturePlacement::cylindrical, turned}},
      {"whole", CubesTexture{1, 2}},
      {"cubes there", PlacedTexture{21, TexturePlacement::space, turned}}};
  for (std::uint32_t texture = 0; texture < scene.textures.size(); ++texture) {
    INFO(scene.textures[texture].name);
    scene.materials[0].textures = {{MaterialInput::reflectance, texture},
                                   {MaterialInput::roughness, texture}};
    const RoundTrip trip = round_trip(scene, "a.pbrt");
    CHECK(trip.warnings.empty());
    const std::vector<TextureUse>& uses = only_material(trip).textures;
    REQUIRE(uses.size() == 2);
    for (const TextureUse& use : uses) {
      CHECK(use.meaning == InputMeaning::value);
      CHECK(are_alike(scene, texture, trip.scene, use.texture, use.input == MaterialInput::roughness));
    }
  }
}

TEST_CASE(
    "written pbrt: marble has its colors, is its mean as a number, and what cannot be placed is named") {
  Scene scene = scene_of(mapped_triangle(), Lambert{});
  const PointTransform turned{{{0, 2, 0, 0.5f}, {-2, 0, 0, 0.25f}, {0, 0, 2, -1}}};
  const UvTransform shifted{{{1, 0, 0.5f}, {0, 1, 0}}};
  scene.textures = {
      {"marble", NoiseTexture{NoisePattern::marble, {3, 0.5f}, 4, 0.3f}},
      {"there", PlacedTexture{0, TexturePlacement::space, turned}},
      {"picture", ImageTexture{odd_picture(), WrapMode::repeat, TextureFilter::bilinear, shifted}},
      {"flat", PlacedTexture{0, TexturePlacement::space, {{{1, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}}}}},
      {"around", PlacedTexture{2, TexturePlacement::spherical, turned}}};
  const auto trip = [&](std::uint32_t texture) {
    scene.materials[0].textures = {{MaterialInput::reflectance, texture}};
    return round_trip(scene, "a.pbrt");
  };
  for (const std::uint32_t texture : {0u, 1u}) {
    const RoundTrip there = trip(texture);
    CHECK(there.warnings.empty());
    CHECK(are_alike(scene, texture, there.scene, only_material(there).textures.at(0).texture, false));
  }
  for (const std::uint32_t texture : {3u, 4u})
    CHECK(trip(texture).warnings == std::vector<std::string>{"a texture that goes by points lies elsewhere"});
  scene.materials[0] = {"", CoatedDiffuse{}};
  scene.materials[0].textures = {{MaterialInput::roughness, 0}};
  const RoundTrip number = round_trip(scene, "a.pbrt");
  CHECK(number.warnings == std::vector<std::string>{"marble that gives a number is its mean"});
  const Rgb mean = mean_value(scene.textures[0].model, {});
  CHECK(std::get<CoatedDiffuse>(only_material(number).model).roughness.x == Approx(mean.r));
}

TEST_CASE("written pbrt: textures of roughnesses and of metals keep what they mean") {
  Scene scene = scene_of(mapped_triangle(), CoatedConductor{});
  scene.textures = {{"picture", ImageTexture{odd_picture(), WrapMode::repeat, TextureFilter::bilinear, {}}}};
  const TextureUse squared{MaterialInput::roughness_u, 0, InputMeaning::squared_roughness};
  const TextureUse metal{MaterialInput::k, 0, InputMeaning::metal_reflectance};
  const TextureUse plain{MaterialInput::coat_roughness, 0, InputMeaning::value};
  std::get<CoatedConductor>(scene.materials[0].model).roughness = {0, 0.25f};
  std::get<CoatedConductor>(scene.materials[0].model).eta = {1, 1, 1};
  scene.materials[0].textures = {squared, metal, plain};
  const RoundTrip trip = round_trip(scene, "a.pbrt");
  CHECK(trip.warnings.empty());
  for (const Vec2 uv : {Vec2{0.2f, 0.3f}, {0.6f, 0.9f}}) {
    const TexturePoint at{.uv = uv, .is_smooth = true};
    const auto a = std::get<CoatedConductor>(textured_model(scene.materials[0], scene.textures, at));
    const auto b = std::get<CoatedConductor>(textured_model(only_material(trip), trip.scene.textures, at));
    CHECK(a.roughness.x == Approx(b.roughness.x));
    CHECK(a.roughness.y == Approx(b.roughness.y));
    CHECK(a.coat_roughness.x == Approx(b.coat_roughness.x));
    CHECK(a.k.g == Approx(b.k.g));
    CHECK(b.eta == Rgb{1, 1, 1});
  }
}

TEST_CASE("written pbrt: holes, bumps and normal maps come back, and turned textures are named") {
  Scene scene = scene_of(mapped_triangle(), Lambert{});
  scene.textures = {
      {"picture", ImageTexture{odd_picture(), WrapMode::repeat, TextureFilter::bilinear, {}}},
      {"third", ConstantTexture{{0.25f, 0.25f, 0.25f}}},
      {"turned",
       ImageTexture{odd_picture(), WrapMode::repeat, TextureFilter::bilinear, {{{0, 1, 0}, {-1, 0, 0}}}}}};
  scene.materials[0].normal_map = scene.materials[0].bump_map = 0;
  for (const std::uint32_t alpha : {0u, 1u}) {
    scene.bindings[0].alpha = alpha;
    scene.geometry =
        std::make_shared<const Geometry>(cut_out({mapped_triangle()}, scene.bindings, scene.textures, {}));
    const RoundTrip trip = round_trip(scene, "a.pbrt");
    CHECK(trip.warnings.empty());
    CHECK(are_alike(scene, alpha, trip.scene, trip.scene.bindings[0].alpha, true));
    CHECK(are_alike(scene, 0, trip.scene, only_material(trip).normal_map, false));
    CHECK(are_alike(scene, 0, trip.scene, only_material(trip).bump_map, true));
  }
  scene.materials[0].textures = {{MaterialInput::reflectance, 2}};
  CHECK(round_trip(scene, "a.pbrt").warnings ==
        std::vector<std::string>{"a texture that is turned lies as if it were not"});
  scene.textures[2].model = ImageTexture{odd_picture(), {WrapMode::clamp, WrapMode::repeat}};
  const RoundTrip trip = round_trip(scene, "a.pbrt");
  CHECK(trip.warnings ==
        std::vector<std::string>{"a picture that goes on otherwise along v than along u does "
                                 "so along both as along u"});
  const std::uint32_t color = only_material(trip).textures.at(0).texture;
  CHECK(std::get<ImageTexture>(trip.scene.textures[color].model).wrap == WrapMode::clamp);
}

}  // namespace twinray::test

// SPDX-License-Identifier: Apache-2.0
#include "core/texture.h"

#include <algorithm>
#include <cmath>

#include "core/scene_textures.h"
#include "core/shading_map.h"
#include "core/textured_material.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"
#include "tests/support/textures.h"

namespace twinray::test {
namespace {

Rgb value(const TextureModel& model, Vec2 uv, float footprint = 0) {
  const Texture texture{"", model};
  return evaluate({&texture, 1}, 0, {uv, footprint});
}

}  // namespace

TEST_CASE("a picture's u runs to the right and its v upwards, and pixels' centres have their values") {
  for (const TextureFilter filter :
       {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear}) {
    const ImageTexture image{ramp(4, 2), WrapMode::clamp, filter, {}};
    CHECK(value(image, {0.125f, 0.25f}) == Rgb{0, 0, 1});
    CHECK(value(image, {0.875f, 0.25f}) == Rgb{3, 0, 1});
    CHECK(value(image, {0.375f, 0.75f}) == Rgb{1, 1, 1});
  }
  const ImageTexture mixed{ramp(4, 2), WrapMode::clamp, TextureFilter::bilinear, {}};
  CHECK(value(mixed, {0.5f, 0.5f}) == Rgb{1.5f, 0.5f, 1});
  const ImageTexture sharp{ramp(4, 2), WrapMode::clamp, TextureFilter::nearest, {}};
  CHECK(value(sharp, {0.49f, 0.51f}) == Rgb{1, 1, 1});
}

TEST_CASE("beside a picture lie the picture again, its edge, or nothing") {
  const auto at = [](Wrap wrap, Vec2 uv) {
    return value(ImageTexture{ramp(4, 2), wrap, TextureFilter::bilinear, {}}, uv);
  };
  CHECK(at(WrapMode::repeat, {2.375f, -0.25f}) == Rgb{1, 1, 1});
  CHECK(at(WrapMode::repeat, {1, 0.25f}) ==
        Rgb{1.5f, 0, 1});  // Half of the last and half of the first column.
  CHECK(at(WrapMode::clamp, {7, -3}) == Rgb{3, 0, 1});
  CHECK(at(WrapMode::black, {1.2f, 0.5f}) == Rgb{});
  CHECK(at(WrapMode::black, {1, 0.25f}) == Rgb{1.5f, 0, 0.5f});
  // In one direction so, in the other otherwise.
  constexpr Wrap ends_in_v{WrapMode::repeat, WrapMode::clamp}, ends_in_u{WrapMode::clamp, WrapMode::black};
  CHECK(at(ends_in_v, {2.375f, -0.25f}) == Rgb{1, 0, 1});
  CHECK(at(ends_in_v, {-0.625f, 1.5f}) == Rgb{1, 1, 1});
  CHECK(at(ends_in_u, {7, 0.25f}) == Rgb{3, 0, 1});
  CHECK(at(ends_in_u, {0.5f, 1.5f}) == Rgb{});
  // Far away, where a float has no fractions left, and beyond all numbers.
  CHECK(at(WrapMode::repeat, {3e30f, 0.25f}).b == 1);
  CHECK(at(WrapMode::clamp, {-3e30f, 0.25f}) == Rgb{0, 0, 1});
  CHECK(at(WrapMode::clamp, {std::numeric_limits<float>::infinity(), 0}) == Rgb{});
  CHECK(at(WrapMode::clamp, {std::numeric_limits<float>::quiet_NaN(), 0}) == Rgb{});
}

TEST_CASE("trilinear filtering takes the level whose pixels are as wide as the footprint") {
  Image noise(64, 64);
  Random random(2);
  for (Rgb& pixel : noise.pixels) pixel = {random.unit(), 0, 0};
  const auto map = std::make_shared<const MipMap>(noise);
  const ImageTexture image{map, WrapMode::repeat, TextureFilter::trilinear, {}};
  const auto centre = [&](int level, int x, int y) {  // Of a pixel of a level.
    const float n = float(map->level(level).width);
    return Vec2{(float(x) + 0.5f) / n, 1 - (float(y) + 0.5f) / n};
  };
  CHECK(value(image, centre(0, 5, 9), 0) == map->level(0).at(5, 9));
  CHECK(value(image, centre(0, 5, 9), 1 / 64.0f) == map->level(0).at(5, 9));
  CHECK(value(image, centre(3, 5, 6), 8 / 64.0f).r == Approx(map->level(3).at(5, 6).r));
  for (const float wide : {100.0f, 1e30f, std::numeric_limits<float>::infinity()})
    CHECK(value(image, {0.3f, 0.4f}, wide) == map->level(6).at(0, 0));
  // Halfway, by the logarithm, between two levels.
  const Vec2 there{0.3f, 0.6f};
  const double between = value(image, there, float(std::sqrt(2.0) * 4 / 64)).r;
  CHECK(between ==
        Approx(0.5 * (double(value(image, there, 4 / 64.0f).r) + double(value(image, there, 8 / 64.0f).r)))
            .epsilon(1e-5));
  // A transform that shrinks the picture widens the footprint on it.
  const ImageTexture dense{map, WrapMode::repeat, TextureFilter::trilinear, {{{8, 0, 0}, {0, 2, 0}}}};
  CHECK(value(dense, {0.01f, 0.02f}, 1 / 64.0f).r == Approx(value(image, {0.08f, 0.04f}, 8 / 64.0f).r));
}

TEST_CASE("stochastic filtering has one pixel for each draw, and trilinear filtering's value for its mean") {
  Image noise(16, 16);
  Random random(3);
  for (Rgb& pixel : noise.pixels) pixel = {random.unit(), 0, 0};
  const auto map = std::make_shared<const MipMap>(noise);
  std::vector<Image> levels;
  for (int level = 0; level < map->levels(); ++level) levels.push_back(map->image(level));
  const ImageTexture one{map, WrapMode::repeat, TextureFilter::stochastic, {}};
  const ImageTexture eight{map, WrapMode::repeat, TextureFilter::trilinear, {}};
  const Texture texture{"", one};
  constexpr int draws = 256;
  for (int i = 0; i < 20; ++i) {
    const Vec2 uv{random.unit(), random.unit()};
    const float footprint = random.unit() * 0.4f;
    double sum = 0;
    for (int y = 0; y < draws; ++y)
      for (int x = 0; x < draws; ++x) {
        const Vec2 draw{(float(x) + 0.5f) / draws, (float(y) + 0.5f) / draws};
        const Rgb value = evaluate({&texture, 1}, 0, {uv, footprint, draw});
        sum += double(value.r);
        bool is_pixel = false;
        for (int level = 0; level < map->levels() && !is_pixel; ++level) {
          const std::vector<Rgb>& pixels = levels[std::size_t(level)].pixels;
          is_pixel = std::find(pixels.begin(), pixels.end(), value) != pixels.end();
        }
        if (!is_pixel) FAIL("no pixel has the value " << value.r);
      }
    // A choice by a step of the draws is off by up to one of them; there are three such choices.
    CHECK(sum / (draws * draws) == Approx(value(eight, uv, footprint).r).margin(3.0 / draws));
  }
}

TEST_CASE("coordinates are transformed before a picture is looked up") {
  const UvTransform turned{{{0, 1, 0.25f}, {-1, 0, 1}}};
  const ImageTexture plain{ramp(4, 4), WrapMode::repeat, TextureFilter::bilinear, {}};
  const ImageTexture moved{ramp(4, 4), WrapMode::repeat, TextureFilter::bilinear, turned};
  CHECK(value(moved, {0.5f, 0.125f}) == value(plain, {0.375f, 0.5f}));
}

TEST_CASE("textures scale, mix and alternate those that stand before them") {
  const std::vector<Texture> textures{red,
                                      half,
                                      {"", ScaleTexture{0, 1}},
                                      {"", MixTexture{0, 1, 1}},
                                      {"", CheckerboardTexture{0, 1, {{{2, 0, 0}, {0, 2, 0}}}}},
                                      {"", ScaleTexture{4, 4}}};
  CHECK_NOTHROW(check_textures(textures));
  CHECK(evaluate(textures, 2, {}) == Rgb{0.5f, 0, 0});
  CHECK(evaluate(textures, 3, {}) == Rgb{0.75f, 0.125f, 0.5f});
  const Rgb first{1, 0, 0}, second{0.5f, 0.25f, 1};
  CHECK(evaluate(textures, 4, {{0.2f, 0.3f}}) == first);
  CHECK(evaluate(textures, 4, {{0.7f, 0.3f}}) == second);
  CHECK(evaluate(textures, 4, {{0.7f, 0.8f}}) == first);
  CHECK(evaluate(textures, 4, {{-0.2f, 0.3f}}) == second);
  CHECK(evaluate(textures, 4, {{-0.2f, -0.3f}}) == first);
  CHECK(evaluate(textures, 5, {{0.7f, 0.3f}}) == second * second);
}

TEST_CASE("a material takes its numbers from textures, within their range, and keeps the rest") {
  const std::vector<Texture> textures{half, {"", ConstantTexture{{2, -1, 0.5f}}}};
  const Material paint{
      "", CoatedDiffuse{.ior = 1.7f}, {{MaterialInput::reflectance, 1}, {MaterialInput::roughness, 0}}};
  const SurfaceModel at = textured_model(paint, textures, {});
  const CoatedDiffuse& coated = std::get<CoatedDiffuse>(at);
  CHECK(coated.reflectance == Rgb{1, 0, 0.5f});
  CHECK(coated.roughness == Roughness{0.5f, 0.5f});
  CHECK(coated.ior == 1.7f);
  const Material blend{"", Mix{3, 4, 0}, {{MaterialInput::amount, 0}}};
  CHECK(std::get<Mix>(textured_model(blend, textures, {})).amount == 0.5f);
  CHECK(has_input(RoughDiffuse{}, MaterialInput::roughness));
  CHECK_FALSE(has_input(Lambert{}, MaterialInput::roughness));
  CHECK_FALSE(has_input(Mix{}, MaterialInput::reflectance));
  CHECK(has_input(Glass{}, MaterialInput::transmittance));
}

TEST_CASE("a metal takes eta, k or its reflectance from textures, and a roughness along each axis") {
  const std::vector<Texture> textures{{"", ConstantTexture{{0.2f, 3000, -1}}},
                                      {"", ConstantTexture{{0.25f, 0.5f, 0}}}};
  const Material metal{"",
                       Conductor{},
                       {{MaterialInput::eta, 0},
                        {MaterialInput::k, 1},
                        {MaterialInput::roughness_u, 1},
                        {MaterialInput::roughness_v, 1, InputMeaning::squared_roughness}}};
  const SurfaceModel at = textured_model(metal, textures, {});
  CHECK(std::get<Conductor>(at).eta == Rgb{0.2f, 1000, 0});
  CHECK(std::get<Conductor>(at).k == Rgb{0.25f, 0.5f, 0});
  CHECK(std::get<Conductor>(at).roughness == Roughness{0.25f, 0.5f});
  const Material coated{"",
                        CoatedConductor{.eta = {1, 1, 1}},
                        {{MaterialInput::k, 1, InputMeaning::metal_reflectance},
                         {MaterialInput::coat_roughness, 1, InputMeaning::squared_roughness}}};
  const SurfaceModel layers = textured_model(coated, textures, {});
  CHECK(std::get<CoatedConductor>(layers).k == metal_k({0.25f, 0.5f, 0}));
  CHECK(std::get<CoatedConductor>(layers).coat_roughness == Roughness{0.5f, 0.5f});
  // What textures may make of the axes needs their directions, whatever the model's own numbers are.
  CHECK(is_anisotropic(metal));
  CHECK_FALSE(is_anisotropic(coated));
  // Light that falls straight on a metal of eta 1: k^2 / (4 + k^2).
  const float k = metal_k({0.25f, 0, 0}).r;
  CHECK(k * k / (4 + k * k) == Approx(0.25));
}

TEST_CASE("a texture of fuzz may be its colour times its weight, point by point") {
  const std::vector<Texture> textures{{"", ConstantTexture{{0.25f, 0.5f, 0}}},
                                      {"", ConstantTexture{{0, 0, 0}}}};
  const auto fuzz = [&](std::uint32_t texture, InputMeaning meaning) {
    return std::get<Principled>(textured_model(
        {"", Principled{.fuzz_weight = 0.75f}, {{MaterialInput::fuzz_color, texture, meaning}}}, textures,
        {}));
  };
  CHECK(fuzz(0, InputMeaning::weighted_color).fuzz_weight == 0.5f);
  CHECK(fuzz(0, InputMeaning::weighted_color).fuzz_color == Rgb{0.5f, 1, 0});
  CHECK(fuzz(1, InputMeaning::weighted_color).fuzz_weight == 0);
  CHECK(fuzz(1, InputMeaning::weighted_color).fuzz_color == Rgb{});
  CHECK(fuzz(0, InputMeaning::value).fuzz_weight == 0.75f);
  CHECK(fuzz(0, InputMeaning::value).fuzz_color == Rgb{0.25f, 0.5f, 0});
}

TEST_CASE("what widens facets widens those of the roughness, wherever it stands among the textures") {
  const std::vector<Texture> textures{{"", ConstantTexture{{0.5f, 0, 0}}},
                                      {"", ConstantTexture{{0.8f, 0, 0}}}};
  const TextureUse rough{MaterialInput::roughness, 1};
  const TextureUse wide{MaterialInput::specular_roughness_anisotropy, 0, InputMeaning::widening};
  const auto alphas = [&](const std::vector<TextureUse>& uses) {
    const auto model = std::get<Principled>(
        textured_model({"", Principled{.specular_roughness = 0.6f}, uses}, textures, {}));
    const float r = model.specular_roughness, ratio = 1 - model.specular_roughness_anisotropy;
    const float along = r * r * std::sqrt(2 / (1 + ratio * ratio));
    return std::pair{along, along * ratio};
  };
  for (const auto& uses : {std::vector{rough, wide}, std::vector{wide, rough}}) {
    CHECK(alphas(uses).first == Approx(0.64 + 0.36 * 0.25));
    CHECK(alphas(uses).second == Approx(0.64));
  }
  CHECK(alphas({wide}).first == Approx(0.36 + 0.64 * 0.25));
  CHECK(alphas({wide}).second == Approx(0.36));
  Principled polished{.specular_roughness = 0};
  widen(polished, 0);
  CHECK(polished.specular_roughness == 0);
  CHECK(polished.specular_roughness_anisotropy == 0);
  CHECK(is_anisotropic(Material{"", Principled{}, {wide}}));
}

TEST_CASE("each input of OpenPBR's surface may be a texture's, and is the member of its name") {
  const std::vector<Texture> textures{{"", ConstantTexture{{0.125f, 0.5f, 0.75f}}}};
  const auto with = [&](MaterialInput input) {
    return std::get<Principled>(textured_model({"", Principled{}, {{input, 0}}}, textures, {}));
  };
  int inputs = 0;
  for (int i = 0; i < material_inputs; ++i) inputs += has_input(Principled{}, MaterialInput(i));
  CHECK(inputs == 21);
  CHECK(with(MaterialInput::base_metalness).base_metalness == 0.125f);
  CHECK(with(MaterialInput::roughness).specular_roughness == 0.125f);
  CHECK(with(MaterialInput::coat_roughness).coat_roughness == 0.125f);
  CHECK(with(MaterialInput::fuzz_color).fuzz_color == Rgb{0.125f, 0.5f, 0.75f});
  CHECK(with(MaterialInput::subsurface_weight).subsurface_weight == 0.125f);
  CHECK(with(MaterialInput::subsurface_color).subsurface_color == Rgb{0.125f, 0.5f, 0.75f});
  CHECK(with(MaterialInput::specular_color).specular_color == Rgb{0.125f, 0.5f, 0.75f});
  CHECK(with(MaterialInput::specular_color).base_color == Principled{}.base_color);
  CHECK(with(MaterialInput::transmission_weight).transmission_weight == 0.125f);
  CHECK(with(MaterialInput::thin_film_weight).thin_film_weight == 0.125f);
  CHECK(with(MaterialInput::thin_film_thickness).thin_film_thickness == 0.125f);
  // Micrometers may be more than 1, and are not less than 0.
  const auto thick = [&](float value) {
    const std::vector<Texture> constant{{"", ConstantTexture{{value, 0, 0}}}};
    const Material film{"", Principled{}, {{MaterialInput::thin_film_thickness, 0}}};
    return std::get<Principled>(textured_model(film, constant, {})).thin_film_thickness;
  };
  CHECK(thick(1.5f) == 1.5f);
  CHECK(thick(-1) == 0);
}

}  // namespace twinray::test

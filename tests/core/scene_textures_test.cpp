// SPDX-License-Identifier: Apache-2.0
#include "core/scene_textures.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/texture.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"
#include "tests/support/textures.h"

namespace twinray::test {

TEST_CASE("a filter is set for all pictures but those whose pixels are to be seen, or are exact") {
  const auto alone = std::make_shared<const MipMap>(std::vector<Image>{Image(4, 2)});
  std::vector<Texture> textures{half,
                                {"", ImageTexture{ramp(4, 2), WrapMode::clamp, TextureFilter::nearest, {}}},
                                {"", ImageTexture{ramp(4, 2), WrapMode::clamp, TextureFilter::bilinear, {}}},
                                {"", ImageTexture{alone, WrapMode::clamp, TextureFilter::bilinear, {}}}};
  set_filter(textures, TextureFilter::trilinear);
  CHECK(std::get<ImageTexture>(textures[1].model).filter == TextureFilter::nearest);
  CHECK(std::get<ImageTexture>(textures[2].model).filter == TextureFilter::trilinear);
  CHECK(std::get<ImageTexture>(textures[3].model).filter == TextureFilter::bilinear);
}

TEST_CASE("pictures whose values are cut off somewhere are not filtered by chance") {
  const auto image = [](const Rgb& pixel) {
    return ImageTexture{std::make_shared<const MipMap>(Image(2, 2, pixel))};
  };
  const auto filters = [](std::vector<Texture> textures) {
    set_filter(textures, TextureFilter::stochastic);
    std::vector<TextureFilter> found;
    for (const Texture& texture : textures)
      if (const auto* picture = std::get_if<ImageTexture>(&texture.model)) found.push_back(picture->filter);
    return found;
  };
  constexpr auto stochastic = TextureFilter::stochastic, trilinear = TextureFilter::trilinear;
  using Filters = std::vector<TextureFilter>;
  const Texture plain{"", image({0, 0.5f, 1})};
  CHECK(filters({plain, {"", image({0, 1.25f, 1})}, {"", image({-0.25f, 0, 0})}}) ==
        Filters{stochastic, trilinear, trilinear});
  // A factor of 2 counts for what it scales alone, and for what else that is mixed with.
  const Texture twice{"", ConstantTexture{{2, 2, 2}}}, once{"", ConstantTexture{{1, 0, 1}}};
  CHECK(filters({plain, plain, twice, {"", ScaleTexture{1, 2}}}) == Filters{stochastic, trilinear});
  CHECK(filters({plain, plain, once, {"", ScaleTexture{1, 2}}}) == Filters{stochastic, stochastic});
  CHECK(filters({plain, plain, plain, twice, {"", ScaleTexture{0, 3}}, {"", MixTexture{1, 4, 2}}}) ==
        Filters{trilinear, trilinear, trilinear});
  std::vector<Texture> others{{"", image({2, 2, 2})}};
  set_filter(others, TextureFilter::bilinear);
  CHECK(std::get<ImageTexture>(others[0].model).filter == TextureFilter::bilinear);
}

TEST_CASE("only patterns are placed") {
  const auto error = [](const TextureModel& model) -> std::string {
    const std::vector<Texture> textures{
        red, {"", CubesTexture{0, 0}}, {"", model}, {"", PlacedTexture{2, TexturePlacement::planar, {}}}};
    try {
      check_textures(textures);
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  };
  const std::string none = "texture 3 places texture 2, which is no pattern";
  CHECK(error(DotsTexture{0, 0}) == "");
  CHECK(error(BilinearTexture{}) == "");
  CHECK(error(CheckerboardTexture{0, 1}) == none);
  CHECK(error(ScaleTexture{0, 0}) == none);
  CHECK(error(ConstantTexture{}) == none);
  CHECK(error(PlacedTexture{1, TexturePlacement::space, {}}) == none);
}

TEST_CASE("textures that go by the point in the scene are told from the others, whatever they are part of") {
  const std::vector<Texture> textures{red,
                                      half,
                                      {"", CubesTexture{0, 1}},
                                      {"", ScaleTexture{0, 1}},
                                      {"", ScaleTexture{1, 2}},
                                      {"", NoiseTexture{}},
                                      {"", MixTexture{0, 1, 5}},
                                      {"", DirectionMixTexture{0, 1}},
                                      {"", CheckerboardTexture{0, 1}},
                                      {"", PlacedTexture{8}}};
  CHECK(go_by_position(textures) ==
        std::vector<bool>{false, false, true, false, true, true, true, true, false, true});
}

TEST_CASE("textures that go by the surface's coordinates are told from the others") {
  const std::vector<TextureModel> models{ConstantTexture{},
                                         CheckerboardTexture{0, 0},
                                         DotsTexture{0, 0},
                                         BilinearTexture{},
                                         CubesTexture{0, 0},
                                         CubesTexture{0, 1},
                                         ScaleTexture{4, 0},
                                         NoiseTexture{},
                                         PlacedTexture{1, TexturePlacement::planar, {}},
                                         PlacedTexture{1, TexturePlacement::space, {}},
                                         PlacedTexture{7, TexturePlacement::space, {}},
                                         ImageTexture{ramp(2, 2)}};
  std::vector<bool> found;
  for (const TextureModel& model : models) found.push_back(goes_by_coordinates(model, found));
  CHECK(found ==
        std::vector<bool>{false, true, true, true, false, true, false, false, false, true, false, true});
}

TEST_CASE("the mean of a texture is that of many points, where its parts are independent") {
  const UvTransform uv{{{1, 0, 0}, {0, 1, 0}}};
  const std::vector<Texture> textures{
      red,
      half,
      {"picture", ImageTexture{ramp(8, 8), WrapMode::repeat, TextureFilter::nearest, {}}},
      {"product", ScaleTexture{1, 2}},
      {"mix", MixTexture{0, 1, 1}},
      {"board", CheckerboardTexture{0, 1, uv}},
      {"cubes", CubesTexture{0, 1}},
      {"dots", DotsTexture{0, 1, {{{20, 0, 0}, {0, 20, 0}}}}},
      {"corners",
       BilinearTexture{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {{{0.125f, 0, 0}, {0, 0.125f, 0}}}}},
      {"direction", DirectionMixTexture{0, 1}},
      {"clouds", NoiseTexture{}},
      {"wrinkles", NoiseTexture{.pattern = NoisePattern::wrinkled}},
      {"waves", NoiseTexture{.pattern = NoisePattern::windy}},
      {"marble", NoiseTexture{.pattern = NoisePattern::marble}},
      {"placed", PlacedTexture{2, TexturePlacement::planar, {}}}};
  std::vector<Rgb> means;
  for (const Texture& texture : textures) {
    CAPTURE(texture.name);
    means.push_back(mean_value(texture.model, means));
    Random random(5);
    constexpr int points = 20000;
    double r = 0, b = 0;
    for (int i = 0; i < points; ++i) {
      const Vec3 p{8 * random.unit(), 8 * random.unit(), 8 * random.unit()};
      const Rgb found =
          evaluate(textures, std::uint32_t(means.size() - 1),
                   {.uv = {p.x, p.y}, .position = p, .normal = normalize(random.in_ball()), .width = 0});
      r += double(found.r) / points, b += double(found.b) / points;
    }
    // Of wrinkles the mean is pbrt's, which counts an octave too much.
    const double margin = texture.name == "wrinkles" ? 0.2 : 0.03;
    CHECK(r == Approx(means.back().r).margin(margin * std::max(1.0, r)));
    CHECK(b == Approx(means.back().b).margin(margin * std::max(1.0, b)));
  }
}

TEST_CASE("a texture of which few statements make very many is an error") {
  std::vector<Texture> doubled{red};
  for (std::uint32_t i = 0; i < 11; ++i) doubled.push_back({"", ScaleTexture{i, i}});
  CHECK_NOTHROW(check_textures(doubled));  // 2^12 - 1 parts.
  doubled.push_back({"", ScaleTexture{11, 0}});
  CHECK_THROWS_WITH(check_textures(doubled), "texture 12 is made of more than 4096 textures");
}

TEST_CASE("a texture that names itself, a later one or no picture is an error") {
  CHECK_THROWS_WITH(check_textures(std::vector<Texture>{red, {"", ScaleTexture{0, 1}}}),
                    "texture 1 names texture 1, which does not stand before it");
  CHECK_THROWS_WITH(check_textures(std::vector<Texture>{red, {"", MixTexture{0, 0, 2}}, half}),
                    "texture 1 names texture 2, which does not stand before it");
  CHECK_THROWS_WITH(check_textures(std::vector<Texture>{{"", CheckerboardTexture{0, 0}}}),
                    "texture 0 names texture 0, which does not stand before it");
  CHECK_THROWS_WITH(check_textures(std::vector<Texture>{{"", ImageTexture{}}}), "texture 0 has no picture");
}

}  // namespace twinray::test

// SPDX-License-Identifier: Apache-2.0
#include "core/texture_pattern.h"

#include <cmath>
#include <memory>
#include <vector>

#include "core/scene_textures.h"
#include "core/texture.h"
#include "tests/support/catch.h"
#include "tests/support/textures.h"

namespace twinray::test {
namespace {

/// Of a texture over `red` and `half`, at a point of the scene.
Rgb value_at(const TextureModel& model, const TexturePoint& at) {
  const std::vector<Texture> textures{red, half, {"", model}};
  check_textures(textures);
  return evaluate(textures, 2, at);
}

}  // namespace

TEST_CASE("cubes alternate in space, and directions mix by the normal on either side") {
  const auto cube = [](const Vec3& p) { return value_at(CubesTexture{0, 1}, {.position = p}).r; };
  CHECK(cube({0.5f, 0.5f, 0.5f}) == 1);
  CHECK(cube({1.5f, 0.5f, 0.5f}) == 0.5f);
  CHECK(cube({0.5f, -0.5f, 0.5f}) == 0.5f);
  CHECK(cube({0.5f, 1.5f, 7.5f}) == 1);
  for (const float side : {-1.0f, 1.0f}) {
    const auto mixed = [&](const Vec3& normal) {
      return value_at(DirectionMixTexture{0, 1, {0, 0, 1}}, {.normal = normal * side});
    };
    CHECK(mixed({0, 0, 1}) == Rgb{1, 0, 0});
    CHECK(mixed({1, 0, 0}) == Rgb{0.5f, 0.25f, 1});
    CHECK(mixed({0, 0.8f, 0.6f}).r == Approx(0.6 + 0.4 * 0.5));
    CHECK(mixed({0, 0, 1.0000001f}).b == 0);
  }
}

TEST_CASE("dots and what lies between corners go by the transformed coordinates") {
  const UvTransform uv{{{2, 0, 0}, {0, 4, 1}}};
  for (int i = 0; i < 200; ++i) {
    const Vec2 at{0.13f * float(i % 20) - 1, 0.17f * float(i / 20) - 1};
    CHECK(value_at(DotsTexture{0, 1, uv}, {.uv = at}).r == (is_in_dot(uv(at)) ? 1 : 0.5f));
  }
  const BilinearTexture square{{1, 0, 0}, {2, 0, 0}, {4, 0, 0}, {8, 0, 1}, uv};
  CHECK(value_at(square, {.uv = {0, -0.25f}}) == Rgb{1, 0, 0});
  CHECK(value_at(square, {.uv = {0.5f, -0.25f}}) == Rgb{2, 0, 0});
  CHECK(value_at(square, {.uv = {0, 0}}) == Rgb{4, 0, 0});
  CHECK(value_at(square, {.uv = {0.5f, 0}}) == Rgb{8, 0, 1});
  CHECK(value_at(square, {.uv = {0.25f, -0.125f}}) == Rgb{3.75f, 0, 0.25f});
  CHECK(value_at(square, {.uv = {1, -0.25f}}) == Rgb{3, 0, 0});  // Beyond its corners.
}

TEST_CASE("noise goes by the point and by the width of what is seen") {
  constexpr float width = 0.01f;
  bool has_negative_gusts = false;
  for (const Vec3 p : {Vec3{0.3f, -0.6f, 4.7f}, Vec3{-4.4f, 3.1f, 2.6f}, Vec3{7.5f, 6.2f, -5.9f}}) {
    const auto at = [&](NoisePattern pattern) {
      return value_at(NoiseTexture{pattern, {5, 0.7f}, 3, 0.4f}, {.position = p, .width = width});
    };
    CHECK(at(NoisePattern::fbm) == white * fbm(p, width, {5, 0.7f}));
    CHECK(at(NoisePattern::wrinkled) == white * turbulence(p, width, {5, 0.7f}));
    const float gusts = fbm(p * 0.1f, width / 10, {3, 0.5f}), waves = fbm(p, width, {6, 0.5f});
    CHECK(at(NoisePattern::windy).g == Approx(std::fabs(gusts) * waves));
    const float phase = 3 * p.y + 0.4f * fbm(p * 3, 3 * width, {5, 0.7f});
    CHECK(at(NoisePattern::marble).b == Approx(marble_color(phase).b));
    has_negative_gusts = has_negative_gusts || gusts < 0;
  }
  CHECK(has_negative_gusts);
}

TEST_CASE("a placed pattern is asked for by its own coordinates") {
  const PointTransform to_texture{{{0, 2, 0, 1}, {0, 0, 2, 0}, {2, 0, 0, 0}}};
  const auto at = [&](const TextureModel& pattern, TexturePlacement placement) {
    const std::vector<Texture> textures{
        red, half, {"", pattern}, {"", PlacedTexture{2, placement, to_texture}}};
    check_textures(textures);
    const TexturePoint point{.uv = {5, 5}, .position = {0.1f, 0.2f, 0.3f}, .width = 0.01f};
    prefetch_texels(textures, 3, point);
    return evaluate(textures, 3, point);
  };
  const ImageTexture picture{ramp(8, 8), WrapMode::repeat, TextureFilter::nearest, {}};
  CHECK(at(picture, TexturePlacement::planar) == Rgb{3, 4, 1});  // At 1.4, 0.6.
  const NoiseTexture clouds;
  CHECK(at(clouds, TexturePlacement::space).r == Approx(fbm({1.4f, 0.6f, 0.2f}, 0.02f, {})));
  CHECK(at(CheckerboardTexture{0, 1}, TexturePlacement::planar) == half_color);
  CHECK(at(CubesTexture{0, 1}, TexturePlacement::space) == half_color);
}

}  // namespace twinray::test

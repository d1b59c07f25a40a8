// SPDX-License-Identifier: Apache-2.0
#include "io/written_scene.h"

#include <cmath>
#include <filesystem>

#include "core/direction_map.h"
#include "core/error.h"
#include "io/picture/baked_texture.h"
#include "io/picture/equal_area.h"
#include "io/scene_writer.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {

TEST_CASE("a scene is written to names of four endings only") {
  for (const char* name : {"a.json", "b/a.b.json", "a.pbrt", "a.gltf", "a b.glb"})
    CHECK_NOTHROW(check_scene_output(name));
  for (const char* name : {"-", "a", "a.dae", ".json", "b/.glb", "a.pbrt/", "a.gltf.gz"})
    CHECK_THROWS_WITH(check_scene_output(name),
                      std::string(name) +
                          ": a scene is written to a file whose name ends in .json, .pbrt, .gltf or .glb; "
                          "other files of it are put beside it");
}

TEST_CASE("losses are counted, a line for each kind in the order of their first ones") {
  Losses losses;
  CHECK(losses.lines("a").empty());
  losses.add("a cat is a dog", "{} cats are dogs");
  losses.add("the sky is black");
  losses.add("a cat is a dog", "{} cats are dogs");
  losses.add("the sky is black");
  CHECK(losses.lines("a/b.c") ==
        std::vector<std::string>{"a/b.c: 2 cats are dogs", "a/b.c: the sky is black"});
}

TEST_CASE("names are used once") {
  UniqueNames names;
  CHECK(names.unique("a", "b") == "a");
  CHECK(names.unique("a 2", "b") == "a 2");
  CHECK(names.unique("a", "b") == "a 3");
  CHECK(names.unique("", "b") == "b");
  CHECK(names.unique("", "b") == "b 2");
}

TEST_CASE("files beside a scene have its name, in its folder") {
  SceneOutput output("folder.x/room.pbrt");
  CHECK(output.add("-1.ply", [](const std::string&) {}) == "room-1.ply");
  const WrittenScene written = output.finish("text");
  REQUIRE(written.files.size() == 2);
  CHECK(written.files[0].path == "folder.x/room-1.ply");
  CHECK(written.files[1].path == "folder.x/room.pbrt");
}

TEST_CASE("what goes by the points of the scene is baked as its mean, and what never repeats in part") {
  const UvTransform uv{{{2, 0, 0.25f}, {0, 4, 0}}};
  const std::vector<Texture> textures{
      {"red", ConstantTexture{{1, 0, 0}}},
      {"blue", ConstantTexture{{0, 0, 0.5f}}},
      {"cubes", CubesTexture{0, 1}},
      {"half of them", ScaleTexture{2, 0}},
      {"dots", DotsTexture{0, 1, uv}},
      {"corners", BilinearTexture{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, uv}}};
  const BakedTexture cubes = bake(textures, 2), half = bake(textures, 3);
  CHECK(cubes.picture.pixels == std::vector<Rgb>{{0.5f, 0, 0.25f}});
  CHECK_FALSE(cubes.is_exact);
  CHECK(half.picture.pixels == std::vector<Rgb>{{0.5f, 0, 0}});
  CHECK_FALSE(half.is_exact);
  for (const std::uint32_t index : {4u, 5u}) {
    const BakedTexture baked = bake(textures, index);
    CHECK_FALSE(baked.is_exact);
    const std::vector<Texture> picture{{"", ImageTexture{std::make_shared<const MipMap>(baked.picture),
                                                         baked.wrap, baked.filter, baked.uv}}};
    // Both have all of the unit square of the transformed coordinates, dots of eight by eight, in steps of
    // 1/32.
    const float side = index == 4 ? 8 : 1;
    int other = 0;
    for (int i = 0; i < 400; ++i) {
      const float u = side * (0.02f + 0.048f * float(i % 20)), v = side * (0.02f + 0.048f * float(i / 20));
      const TexturePoint at{.uv = {(u - 0.25f) / 2, v / 4}, .is_smooth = true};
      const Rgb wanted = evaluate(textures, index, at), found = evaluate(picture, 0, at);
      other += std::fabs(wanted.r - found.r) > 0.003f || std::fabs(wanted.g - found.g) > 0.003f;
    }
    CHECK(other <= (index == 4 ? 12 : 0));
  }
}

TEST_CASE("a baked board is a picture of two by two points, which repeats as it does") {
  const UvTransform uv{{{4, 0, 0.5f}, {0, 2, 0}}};
  const std::vector<Texture> textures{{"", ConstantTexture{{1, 0, 0}}},
                                      {"", ConstantTexture{{0, 1, 0}}},
                                      {"", CheckerboardTexture{0, 1, uv}}};
  const BakedTexture baked = bake(textures, 2);
  CHECK(baked.is_exact);
  CHECK(baked.picture.pixels.size() == 4);
  const std::vector<Texture> picture{
      {"", ImageTexture{std::make_shared<const MipMap>(baked.picture), baked.wrap, baked.filter, baked.uv}}};
  for (int i = 0; i < 100; ++i) {
    const TexturePoint at{.uv = {0.173f * float(i % 10) - 0.53f, 0.211f * float(i / 10) - 0.53f}};
    CHECK(evaluate(textures, 2, at) == evaluate(picture, 0, at));
  }
}

TEST_CASE(
    "a baked product of pictures that lie alike is exact at their pixels, and others are drawn over the "
    "square") {
  Image small(2, 2), large(4, 4);
  for (std::size_t i = 0; i < 16; ++i) large.pixels[i] = {float(i), 1, 1};
  small.pixels = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
  const UvTransform uv{{{2, 0, 0}, {0, 2, 0}}};
  const auto texture = [&](const Image& image, const UvTransform& placed) {
    return Texture{"", ImageTexture{std::make_shared<const MipMap>(image), WrapMode::repeat,
                                    TextureFilter::nearest, placed}};
  };
  std::vector<Texture> textures{texture(small, uv), texture(large, uv), {"", ScaleTexture{0, 1}}};
  const BakedTexture alike = bake(textures, 2);
  CHECK(alike.is_exact);
  REQUIRE(alike.picture.width == 4);
  CHECK(alike.uv.m[0][0] == 2);
  CHECK(alike.picture.at(0, 0).r == 0);
  CHECK(alike.picture.at(3, 0).r == 2 * 3);
  CHECK(alike.picture.at(3, 3).r == 4 * 15);
  textures[1] = texture(large, {});
  const BakedTexture apart = bake(textures, 2);
  CHECK_FALSE(apart.is_exact);
  CHECK(apart.uv.m[0][0] == 1);
  CHECK(bake(textures, 0).picture.pixels == small.pixels);
  // As one, but for how they go on along v.
  textures[1] = texture(large, uv);
  std::get<ImageTexture>(textures[1].model).wrap = {WrapMode::repeat, WrapMode::clamp};
  CHECK_FALSE(bake(textures, 2).is_exact);
}

TEST_CASE(
    "boards and pictures that lie differently are drawn with texels enough to show each of their squares") {
  Image dots(4, 4);
  for (std::size_t i = 0; i < 16; ++i) dots.pixels[i] = {i % 3 == 0 ? 1.0f : 0.25f, 1, 1};
  const std::vector<Texture> textures{{"", ConstantTexture{{0.25f, 1, 1}}},
                                      {"", ConstantTexture{white}},
                                      {"", CheckerboardTexture{0, 1, {{{3, 0, 0.3f}, {0, 5, 0.7f}}}}},
                                      {"", CheckerboardTexture{0, 1, {{{0, 7, 0}, {45, 0, 0}}}}},
                                      {"", ImageTexture{std::make_shared<const MipMap>(dots),
                                                        WrapMode::repeat,
                                                        TextureFilter::nearest,
                                                        {{{20, 0, 0}, {0, 20, 0}}}}},
                                      {"", ScaleTexture{2, 3}},
                                      {"", ScaleTexture{3, 4}}};
  for (const std::uint32_t product : {5u, 6u}) {
    const BakedTexture baked = bake(textures, product);
    CHECK_FALSE(baked.is_exact);
    const std::vector<Texture> picture{{"", ImageTexture{std::make_shared<const MipMap>(baked.picture),
                                                         baked.wrap, baked.filter, baked.uv}}};
    int different = 0;
    constexpr int points = 200;
    for (int i = 0; i < points * points; ++i) {
      const TexturePoint at{
          .uv = {(float(i % points) + 0.37f) / points, (float(i / points) + 0.61f) / points}};
      different += evaluate(textures, product, at) != evaluate(picture, 0, at);
    }
    CHECK(different < points * points / 10);  // Along edges.
  }
}

TEST_CASE("a picture of what lies differently has a bound, however often its parts repeat") {
  const std::vector<Texture> textures{{"", ConstantTexture{white}},
                                      {"", CheckerboardTexture{0, 0, {{{1e6f, 0, 0}, {0, 1e6f, 0}}}}},
                                      {"", CheckerboardTexture{0, 0, {}}},
                                      {"", ScaleTexture{1, 2}},
                                      {"", ImageTexture{std::make_shared<const MipMap>(Image(3000, 2))}},
                                      {"", ScaleTexture{1, 4}}};
  CHECK(bake(textures, 3).picture.width == 2048);
  CHECK(bake(textures, 5).picture.width == 3000);  // A picture keeps its texels.
}

TEST_CASE("a sky of latitude and longitude that is drawn anew has the same colors in the same directions") {
  Image map(64, 32);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x) map.at(x, y) = {float(y), float(x < 32 ? x : 64 - x), 1};
  const Image square = equal_area_of(map, MapLayout::latitude_longitude);
  CHECK(square.width == 64);  // The least: a coarse sky is not drawn as coarse.
  CHECK(square.height == 64);
  CHECK(equal_area_of(Image(200, 100), MapLayout::latitude_longitude).width == 113);
  const auto value = [](const Image& image, MapLayout layout, const Vec3& direction) {
    return map_value(layout, image, map_point(layout, direction));
  };
  for (const Vec3& d : {Vec3{1, 0.1f, 0.2f},
                        {-1, 0.3f, 0.1f},
                        {0.1f, 1, 0.2f},
                        {0.2f, -1, 0.1f},
                        {0.1f, 0.2f, 1},
                        {0.2f, 0.1f, -1}}) {
    const Rgb wanted = value(map, MapLayout::latitude_longitude, d);
    const Rgb drawn = value(square, MapLayout::equal_area, d);
    CHECK(drawn.r == Approx(wanted.r).margin(0.1));  // Each row of the map is 1 more than the one above.
    CHECK(drawn.b == Approx(1));
    if (std::fabs(d.y) < 0.5f) CHECK(drawn.g == Approx(wanted.g).margin(0.1));
  }
}

TEST_CASE("where one file of a scene cannot be written, those that were not there before go") {
  const TemporaryFolder folder;
  const std::string old = folder.file("old"), added = folder.file("new"), bad = folder.file("bad");
  write_text(old, "old");
  const auto writes = [](const std::string& path) { write_text(path, "text"); };
  const auto fails = [](const std::string&) { throw Error("the disk is full"); };
  CHECK_THROWS_AS(write_files({{{old, writes}, {added, writes}, {bad, fails}}, {}}), Error);
  CHECK(std::filesystem::exists(old));
  CHECK_FALSE(std::filesystem::exists(added));
  write_files({{{old, writes}, {added, writes}}, {}});
  CHECK(std::filesystem::exists(added));
}

}  // namespace twinray::test

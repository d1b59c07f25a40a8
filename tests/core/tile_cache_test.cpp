// SPDX-License-Identifier: Apache-2.0
#include "core/tiled_picture.h"

#include <atomic>
#include <set>
#include <utility>

#include "core/error.h"
#include "core/mip_map.h"
#include "core/parallel.h"
#include "core/scene_textures.h"
#include "core/texture.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"

namespace twinray::test {
namespace {

constexpr std::uint64_t tile_bytes = texels_a_tile * sizeof(Rgb);

/// A texel that says where it is: its tile, and its place there.
Rgb named(std::uint32_t tile, std::size_t texel) { return {float(tile), float(texel), 0.5f}; }

/// Counts how often it is asked.
class NamedTiles final : public TileSource {
 public:
  explicit NamedTiles(std::atomic<int>& reads) : reads_(reads) {}
  void read(std::uint32_t tile, std::span<Rgb> texels) const override {
    ++reads_;
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = named(tile, i);
  }

 private:
  std::atomic<int>& reads_;
};

class NoTiles final : public TileSource {
 public:
  void read(std::uint32_t, std::span<Rgb>) const override { throw Error("the disk is gone"); }
};

Rgb expected(const TileLayout& layout, int level, int x, int y) {
  const TileLayout::Place place = layout.place(level, x, y);
  return named(place.tile, place.texel);
}

}  // namespace

TEST_CASE("each texel of all levels has a place of its own in the tiles of a picture") {
  for (const auto& [width, height] :
       {std::pair{300, 130}, std::pair{64, 64}, std::pair{65, 1}, std::pair{1, 1}, std::pair{33, 200}}) {
    CAPTURE(width, height);
    const TileLayout layout(width, height);
    const MipMap map{Image(width, height)};
    REQUIRE(layout.levels() == map.levels());
    std::set<std::pair<std::uint32_t, std::uint32_t>> places;
    std::size_t texels = 0;
    for (int level = 0; level < map.levels(); ++level) {
      REQUIRE(layout.level(level).width == map.level(level).width);
      REQUIRE(layout.level(level).height == map.level(level).height);
      for (int y = 0; y < map.level(level).height; ++y)
        for (int x = 0; x < map.level(level).width; ++x, ++texels) {
          const TileLayout::Place place = layout.place(level, x, y);
          REQUIRE(place.tile < layout.tiles());
          REQUIRE(place.texel < texels_a_tile);
          places.insert({place.tile, place.texel});
        }
    }
    CHECK(places.size() == texels);
  }
  CHECK(TileLayout(32, 32).tiles() == 1);
  CHECK(TileLayout(300, 130).tiles() == 5 * 3 + 3 * 2 + 2 + 1 + 1);  // 300, 150, 75, 37, and the small ones.
}

TEST_CASE("a cache of one tile gives the texels that a large one gives, and reads far more") {
  std::atomic<int> few = 0, many = 0;
  const TileLayout layout(500, 300);
  const auto large = std::make_shared<TileCache>(100 * tile_bytes), small = std::make_shared<TileCache>(1);
  const TiledPicture in_large(layout, large, std::make_unique<NamedTiles>(few));
  const TiledPicture in_small(layout, small, std::make_unique<NamedTiles>(many));
  Random random(3);
  for (int i = 0; i < 5000; ++i) {
    const int level = int(random.unit() * 9), w = layout.level(level).width, h = layout.level(level).height;
    const int x = int(random.unit() * float(w)), y = int(random.unit() * float(h));
    REQUIRE(in_large.texel(level, x, y) == expected(layout, level, x, y));
    REQUIRE(in_small.texel(level, x, y) == expected(layout, level, x, y));
  }
  CHECK(few == int(layout.tiles()));
  CHECK(many > 2500);
  CHECK(large->statistics().lookups == 5000);
  CHECK(large->statistics().tiles_read == std::uint64_t(few));
  CHECK(large->statistics().peak_bytes == layout.tiles() * tile_bytes);
  CHECK(small->statistics().tiles_read == std::uint64_t(many));
  CHECK(small->statistics().peak_bytes == tile_bytes);
}

TEST_CASE("a cache holds no more than its bound, and gives up the tile that was not asked for") {
  std::atomic<int> reads = 0;
  const auto cache = std::make_shared<TileCache>(3 * tile_bytes + 17);
  CHECK(cache->most_bytes() == 3 * tile_bytes);
  const TiledPicture picture(TileLayout(1024, 64), cache, std::make_unique<NamedTiles>(reads));
  const auto ask = [&](int tile) { picture.texel(0, tile * tile_side, 0); };
  for (const int tile : {0, 1, 2}) ask(tile);
  ask(0), ask(2);
  CHECK(reads == 3);
  ask(3);  // Takes the place of 1.
  ask(0), ask(2), ask(3);
  CHECK(reads == 4);
  ask(1), ask(1);  // It is back, and stays.
  CHECK(reads == 5);
  CHECK(cache->statistics().peak_bytes == 3 * tile_bytes);
}

TEST_CASE("threads that share a cache of a few tiles all see the right texels") {
  std::atomic<int> reads = 0, wrong = 0;
  const auto cache = std::make_shared<TileCache>(2 * tile_bytes);
  const TileLayout layout(256, 256);
  const TiledPicture picture(layout, cache, std::make_unique<NamedTiles>(reads));
  parallel_for(64, 1, 8, [&](std::size_t begin, std::size_t) {
    Random random(begin);
    for (int i = 0; i < 500; ++i) {
      const int x = int(random.unit() * 256), y = int(random.unit() * 80);
      if (picture.texel(0, x, y) != expected(layout, 0, x, y)) ++wrong;
    }
  });
  CHECK(wrong == 0);
  CHECK(cache->statistics().lookups == 64 * 500);
}

TEST_CASE("a picture that is gone leaves its room to others") {
  std::atomic<int> reads = 0;
  const auto cache = std::make_shared<TileCache>(2 * tile_bytes);
  const TileLayout layout(128, 64);
  {
    const TiledPicture picture(layout, cache, std::make_unique<NamedTiles>(reads));
    picture.texel(0, 0, 0), picture.texel(0, 64, 0);
  }
  const TiledPicture other(layout, cache, std::make_unique<NamedTiles>(reads));
  for (int round = 0; round < 2; ++round)
    for (const int x : {0, 64}) CHECK(other.texel(0, x, 5) == expected(layout, 0, x, 5));
  CHECK(reads == 4);
}

TEST_CASE("tiles that cannot be read are magenta, counted, and the first reason is kept") {
  const auto cache = std::make_shared<TileCache>(2 * tile_bytes);
  const TiledPicture picture(TileLayout(128, 64), cache, std::make_unique<NoTiles>());
  CHECK(picture.texel(0, 0, 0) == Rgb{1, 0, 1});
  CHECK(picture.texel(0, 70, 0) == Rgb{1, 0, 1});
  CHECK(cache->statistics().tiles_failed == 2);
  CHECK(cache->statistics().first_failure == "the disk is gone");
}

TEST_CASE("the pictures that an alpha is made of are brought into memory, and no others") {
  std::atomic<int> reads = 0;
  const auto cache = std::make_shared<TileCache>(tile_bytes);
  const auto tiled = [&] {
    return std::make_shared<const MipMap>(
        std::make_unique<const TiledPicture>(TileLayout(100, 70), cache, std::make_unique<NamedTiles>(reads)),
        false);
  };
  std::vector<Texture> textures{{"a", ImageTexture{.image = tiled()}},
                                {"b", ImageTexture{.image = tiled()}},
                                {"c", ConstantTexture{}},
                                {"alpha", MixTexture{2, 0, 2}},
                                {"d", ImageTexture{.image = tiled()}}};
  const TextureModel before = textures[0].model;
  keep_in_memory(textures, 3);
  const auto& kept = *std::get<ImageTexture>(textures[0].model).image;
  const auto& as_it_was = *std::get<ImageTexture>(before).image;
  CHECK(kept.is_in_memory());
  CHECK_FALSE(std::get<ImageTexture>(textures[1].model).image->is_in_memory());
  CHECK_FALSE(std::get<ImageTexture>(textures[4].model).image->is_in_memory());
  REQUIRE(kept.levels() == as_it_was.levels());
  for (int level = 0; level < kept.levels(); ++level)
    CHECK(kept.image(level).pixels == as_it_was.image(level).pixels);
}

}  // namespace twinray::test

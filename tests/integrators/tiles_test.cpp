// SPDX-License-Identifier: Apache-2.0
#include "integrators/tiles.h"

#include <vector>

#include "tests/support/catch.h"

namespace twinray {

TEST_CASE("tiles cover each pixel of a window exactly once") {
  for (const PixelRect window : {PixelRect{0, 0, 1, 1}, PixelRect{0, 0, 100, 37}, PixelRect{5, 9, 22, 90},
                                 PixelRect{3, 0, 4, 400}, PixelRect{0, 0, 64, 64}}) {
    std::vector<int> covered(std::size_t(window.x1) * std::size_t(window.y1), 0);
    for (const PixelRect& tile : spiral_tiles(window, 16)) {
      REQUIRE(tile.width() >= 1);
      REQUIRE(tile.width() <= 16);
      REQUIRE(tile.height() >= 1);
      REQUIRE(tile.height() <= 16);
      for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x)
          ++covered[std::size_t(y) * std::size_t(window.x1) + std::size_t(x)];
    }
    for (int y = 0; y < window.y1; ++y)
      for (int x = 0; x < window.x1; ++x)
        REQUIRE(covered[std::size_t(y) * std::size_t(window.x1) + std::size_t(x)] ==
                int(x >= window.x0 && y >= window.y0));
  }
}

TEST_CASE("the first tile is the middle one and its neighbours follow") {
  const auto tiles = spiral_tiles({0, 0, 80, 80}, 16);
  REQUIRE(tiles.size() == 25);
  CHECK(tiles[0] == PixelRect{32, 32, 48, 48});
  for (std::size_t i = 1; i < 9; ++i) {
    CHECK(std::abs(tiles[i].x0 - 32) <= 16);
    CHECK(std::abs(tiles[i].y0 - 32) <= 16);
  }
}

TEST_CASE("tiles of a range count row by row, and lie in the rows that they need") {
  const PixelRect window{3, 2, 38, 29};  // 3 x 2 tiles
  CHECK(tile_grid(window, 16).count() == 6);
  CHECK(rows_of({0, 3}, window, 16) == PixelRect{3, 2, 38, 18});
  CHECK(rows_of({2, 4}, window, 16) == window);
  CHECK(rows_of({3, 6}, window, 16) == PixelRect{3, 18, 38, 29});
  CHECK(spiral_tiles(window, 16, TileRange{2, 3}) == std::vector<PixelRect>{{35, 2, 38, 18}});
  CHECK(spiral_tiles(window, 16, TileRange{3, 4}) == std::vector<PixelRect>{{3, 18, 19, 29}});
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "integrators/tiles.h"

#include <algorithm>

namespace twinray {

TileGrid tile_grid(const PixelRect& window, int size) {
  return {(window.width() + size - 1) / size, (window.height() + size - 1) / size};
}

PixelRect tile_at(const PixelRect& window, int size, int column, int row) {
  const int x0 = window.x0 + column * size, y0 = window.y0 + row * size;
  return {x0, y0, std::min(x0 + size, window.x1), std::min(y0 + size, window.y1)};
}

PixelRect rows_of(const TileRange& tiles, const PixelRect& window, int size) {
  const auto columns = std::uint32_t(tile_grid(window, size).columns);
  const PixelRect first = tile_at(window, size, 0, int(tiles.begin / columns));
  const PixelRect last = tile_at(window, size, 0, int((tiles.end - 1) / columns));
  return {window.x0, first.y0, window.x1, last.y1};
}

std::vector<PixelRect> spiral_tiles(const PixelRect& window, int size, std::optional<TileRange> range) {
  const TileGrid grid = tile_grid(window, size);
  const TileRange wanted = range.value_or(TileRange{0, grid.count()});
  std::vector<PixelRect> tiles;
  tiles.reserve(wanted.end - wanted.begin);
  int column = (grid.columns - 1) / 2, row = (grid.rows - 1) / 2, dx = 1, dy = 0;
  const auto take = [&] {
    if (column < 0 || column >= grid.columns || row < 0 || row >= grid.rows) return;
    const auto number = std::uint32_t(row) * std::uint32_t(grid.columns) + std::uint32_t(column);
    if (number >= wanted.begin && number < wanted.end) tiles.push_back(tile_at(window, size, column, row));
  };
  for (int run = 1; tiles.size() < wanted.end - wanted.begin; run += dy == 0 ? 1 : 0) {
    for (int step = 0; step < run; ++step, column += dx, row += dy) take();
    const int turned = dx;  // right, down, left, up: a quarter turn, longer by one after every second
    dx = -dy;
    dy = turned;
  }
  return tiles;
}

}  // namespace twinray

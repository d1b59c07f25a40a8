// SPDX-License-Identifier: Apache-2.0
#include "integrators/tiles.h"

#include <algorithm>

namespace twinray {
namespace {

PixelRect tile_at(const PixelRect& window, int size, int column, int row) {
  const int x0 = window.x0 + column * size, y0 = window.y0 + row * size;
  return {x0, y0, std::min(x0 + size, window.x1), std::min(y0 + size, window.y1)};
}

}  // namespace

std::vector<PixelRect> spiral_tiles(const PixelRect& window, int size) {
  const int columns = (window.width() + size - 1) / size, rows = (window.height() + size - 1) / size;
  std::vector<PixelRect> tiles;
  tiles.reserve(std::size_t(columns) * std::size_t(rows));
  int column = (columns - 1) / 2, row = (rows - 1) / 2, dx = 1, dy = 0;
  const std::size_t all = std::size_t(columns) * std::size_t(rows);
  for (int run = 1; tiles.size() < all; run += dy == 0 ? 1 : 0) {
    for (int step = 0; step < run; ++step, column += dx, row += dy)
      if (column >= 0 && column < columns && row >= 0 && row < rows)
        tiles.push_back(tile_at(window, size, column, row));
    const int turned = dx;  // right, down, left, up: a quarter turn, longer by one after every second
    dx = -dy;
    dy = turned;
  }
  return tiles;
}

}  // namespace twinray

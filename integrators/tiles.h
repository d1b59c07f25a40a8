// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/film.h"

namespace twinray {

/// How many tiles a window is cut into: rows of them, each of so many columns.
struct TileGrid {
  int columns = 0, rows = 0;
  std::uint32_t count() const { return std::uint32_t(columns) * std::uint32_t(rows); }
};
TileGrid tile_grid(const PixelRect& window, int size);
/// The tile of a window in this column and row: up to size x size pixels.
PixelRect tile_at(const PixelRect& window, int size, int column, int row);

/// Tiles [begin, end) of those of a window, which count row by row.
struct TileRange {
  std::uint32_t begin = 0, end = 0;
  bool operator==(const TileRange&) const = default;
};
/// The rows of the window in which these tiles lie. There is one at least.
PixelRect rows_of(const TileRange& tiles, const PixelRect& window, int size);

/// Cuts a window into tiles of up to size x size pixels, ordered in a spiral from its middle outward: what a
/// viewer looks at first is done first. Each pixel lies in exactly one tile. Of a range, those in it alone.
std::vector<PixelRect> spiral_tiles(const PixelRect& window, int size, std::optional<TileRange> range = {});

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "core/tile_layout.h"

#include <algorithm>

namespace twinray {
namespace {

std::uint32_t tiles_along(int texels) { return (std::uint32_t(texels) + tile_side - 1) / tile_side; }

}  // namespace

TileLayout::TileLayout(int width, int height) {
  std::uint32_t offset = 0;  // In the last tile.
  for (;; width = std::max(width / 2, 1), height = std::max(height / 2, 1)) {
    Level level{width, height};
    if (std::max(width, height) > tile_side / 2) {
      level.first_tile = tiles_;
      level.columns = tiles_along(width);
      tiles_ += level.columns * tiles_along(height);
    } else {
      level.first_tile = tiles_;  // No tile is counted before the last level.
      level.offset = offset;
      level.stride = std::uint32_t(width);
      offset += std::uint32_t(width) * std::uint32_t(height);
    }
    levels_.push_back(level);
    if (width == 1 && height == 1) break;
  }
  ++tiles_;
}

}  // namespace twinray

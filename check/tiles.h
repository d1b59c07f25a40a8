// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <vector>

#include "core/film.h"

namespace twinray {

/// A picture as squares of so many pixels, row by row; those at its right and lower border may be smaller.
inline std::vector<PixelRect> tiles_of(int width, int height, int tile_size) {
  std::vector<PixelRect> tiles;
  for (int y = 0; y < height; y += tile_size)
    for (int x = 0; x < width; x += tile_size)
      tiles.push_back({x, y, std::min(x + tile_size, width), std::min(y + tile_size, height)});
  return tiles;
}

}  // namespace twinray

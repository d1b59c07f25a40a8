// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <vector>

#include "core/film.h"

namespace twinray {

/// A picture as squares of so many pixels, row by row; those at its right and lower border may be smaller.
inline std::vector<PixelRect> tiles_of(int width, int height, int tile_edge) {
  std::vector<PixelRect> tiles;
  for (int y = 0; y < height; y += tile_edge)
    for (int x = 0; x < width; x += tile_edge)
      tiles.push_back({x, y, std::min(x + tile_edge, width), std::min(y + tile_edge, height)});
  return tiles;
}

}  // namespace twinray

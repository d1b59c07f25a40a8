// SPDX-License-Identifier: Apache-2.0
// Where the texels of a picture with its mip-map lie, if it is cut into square tiles.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace twinray {

inline constexpr int tile_side = 64;
inline constexpr std::size_t texels_a_tile = std::size_t(tile_side) * tile_side;

/// Which tile a texel of a mip-map's level lies in, and where there. Levels wider or higher than half a tile
/// have tiles of their own, row by row, those at the right and at the bottom filled up; all smaller ones
/// share the last tile, one behind the other.
class TileLayout {
 public:
  struct Level {
    int width = 0, height = 0;
    std::uint32_t first_tile = 0, columns = 1;
    std::uint32_t offset = 0, stride = tile_side;  ///< Within a tile, in texels.
  };
  struct Place {
    std::uint32_t tile = 0, texel = 0;
  };

  /// Of a picture with at least one pixel; levels as MipMap's.
  TileLayout(int width, int height);

  int levels() const { return int(levels_.size()); }
  const Level& level(int index) const { return levels_[std::size_t(index)]; }
  std::uint32_t tiles() const { return tiles_; }
  Place place(int index, int x, int y) const {
    const Level& in = level(index);
    const auto column = std::uint32_t(x), row = std::uint32_t(y);
    return {in.first_tile + row / tile_side * in.columns + column / tile_side,
            in.offset + row % tile_side * in.stride + column % tile_side};
  }

 private:
  std::vector<Level> levels_;
  std::uint32_t tiles_ = 0;
};

}  // namespace twinray

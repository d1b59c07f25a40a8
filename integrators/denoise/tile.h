// SPDX-License-Identifier: Apache-2.0
// Private: a picture as the filter walks over it, tile by tile, with as much around each as it looks at.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/plane.h"

namespace twinray {

inline constexpr int tile_width = 32, tile_height = 16;  ///< Compilers know the length of all inner loops.
inline constexpr int window_radius = 7;                  ///< Of the neighbours of a pixel.
inline constexpr int patch_radius = 2;                   ///< Of what is compared around two pixels.
inline constexpr int tile_margin = window_radius + patch_radius;

/// A number for each pixel of a tile.
using TilePlane = std::array<std::array<float, tile_width>, tile_height>;

/// A step from a pixel to a neighbour.
struct Step {
  int x = 0, y = 0;
};

/// What there is beyond a plane's border.
enum class Beyond { border, zero };

/// A plane that goes on beyond its borders, so that each tile of it is whole and has its margin.
class PaddedPlane {
 public:
  explicit PaddedPlane(const Plane& plane, Beyond beyond = Beyond::border)
      : stride_(rounded_up(plane.width, tile_width) + 2 * tile_margin),
        values_(std::size_t(stride_) * std::size_t(rounded_up(plane.height, tile_height) + 2 * tile_margin)) {
    float* next = values_.data();
    for (int y = -tile_margin; y < int(values_.size()) / stride_ - tile_margin; ++y)
      for (int x = -tile_margin; x < stride_ - tile_margin; ++x) {
        const int row = std::clamp(y, 0, plane.height - 1), column = std::clamp(x, 0, plane.width - 1);
        const bool is_kept = beyond == Beyond::border || (row == y && column == x);
        *next++ = is_kept ? plane.row(row)[column] : 0;
      }
  }
  /// The pixel x, y, and after it those of its row.
  const float* at(int x, int y) const {
    return values_.data() + std::size_t(y + tile_margin) * std::size_t(stride_) +
           std::size_t(x + tile_margin);
  }

 private:
  static int rounded_up(int size, int to) { return (size + to - 1) / to * to; }

  int stride_;
  std::vector<float> values_;
};

inline std::vector<PaddedPlane> padded(std::span<const Plane> planes) {
  return {planes.begin(), planes.end()};
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "integrators/tiles.h"

namespace twinray {

/// What somebody who looks at a picture is sent of it.
struct LiveBytes {
  std::uint64_t version = 0;  ///< What changes later has a greater one.
  std::size_t tiles = 0;      ///< How many are in it.
  std::string bytes;          ///< 32-bit numbers, little-endian.
};

/// A picture in tiles of tile_size pixels, each with the version in which it last changed. The threads of a
/// render write it, each tile one of them at a time, while another one reads.
class LiveImage {
 public:
  using Clock = std::chrono::steady_clock;

  /// Of pixels with so many channels. No tile is there yet.
  LiveImage(const PixelRect& window, std::size_t channels);

  int width() const { return window_.width(); }
  int height() const { return window_.height(); }

  /// Whether a tile that the film has changed is to be put now: not within a fifth of a second of the last
  /// time. It is old then.
  bool is_due(const PixelRect& tile, Clock::time_point now);
  /// Whether it is not the film's any longer, or never was.
  bool is_old(const PixelRect& tile) const;
  /// All tiles are old.
  void age();
  /// The values of a tile's pixels, row by row; a new version where they are others than before.
  void put(const PixelRect& tile, std::span<const float> values, Clock::time_point now);

  /// The number of changes so far; 0 as long as a tile was never put.
  std::uint64_t version() const;
  /// All pixels, row by row from the top left.
  LiveBytes all() const;
  /// The tiles that changed after a version: of each the column and the row of its first pixel in the
  /// picture, its width and height as whole numbers, and its values row by row.
  LiveBytes changed_since(std::uint64_t version) const;

 private:
  struct Tile {
    std::uint64_t version = 0;  ///< 0: never put.
    bool is_old = true;
    Clock::time_point put = {};
  };
  std::size_t number_of(const PixelRect& tile) const;
  /// Where the row of the tile begins among the values.
  std::size_t place_of(const PixelRect& tile, int row) const;

  PixelRect window_;
  std::size_t channels_;
  TileGrid grid_;
  mutable std::mutex mutex_;  ///< Of all below.
  std::vector<Tile> tiles_;
  std::vector<float> values_;
  std::uint64_t version_ = 0;
  std::size_t missing_;  ///< Tiles that were never put.
};

}  // namespace twinray

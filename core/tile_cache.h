// SPDX-License-Identifier: Apache-2.0
// Tiles of pictures, of which only some are in memory at a time: those that were asked for last. Where the
// others are, a TileSource knows.
#pragma once
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "core/rgb.h"
#include "core/tile_layout.h"

namespace twinray {

/// Where tiles come from. Any number of threads may ask.
class TileSource {
 public:
  virtual ~TileSource() = default;
  /// Fills the texels_a_tile texels of a tile of the layout, always with the same; what lies beside a level
  /// may be anything. Throws Error where it cannot.
  virtual void read(std::uint32_t tile, std::span<Rgb> texels) const = 0;
};

/// What a cache did since it was made.
struct TileStatistics {
  std::uint64_t lookups = 0;       ///< Texels that were asked for.
  std::uint64_t tiles_read = 0;    ///< By sources: more than lookups missed by none.
  std::uint64_t peak_bytes = 0;    ///< Of tiles in memory at once.
  std::uint64_t tiles_failed = 0;  ///< Could not be read, and are magenta.
  std::string first_failure;       ///< Why; empty without any.
};

/// The tiles of any number of pictures that are in memory. A texel that is there is found without a lock: its
/// tile's version is the same before and after it is read (a sequence lock), else it counts as missing. One
/// that is missing costs its whole tile, which takes the place of one that was not asked for since the
/// clock's hand last passed it (Corbato, "A Paging Experiment with the Multics System", 1968).
class TileCache {
 public:
  class Frame;
  /// Where a picture keeps which frame has a tile of it; null: none.
  using Slot = std::atomic<Frame*>;

  /// `bytes`: of tiles; room for one there is always.
  explicit TileCache(std::uint64_t bytes);
  ~TileCache();
  TileCache(const TileCache&) = delete;
  TileCache& operator=(const TileCache&) = delete;

  /// A texel of the tile that the slot is for. Magenta where the source fails.
  Rgb texel(Slot& slot, const TileSource& source, const TileLayout::Place& place);
  /// The slots will be no more.
  void forget(std::span<Slot> slots);
  TileStatistics statistics() const;
  std::uint64_t most_bytes() const;

 private:
  void read(const TileSource& source, std::uint32_t tile, std::span<Rgb> texels);
  void keep(Slot& slot, std::span<const Rgb> texels);
  Frame& free_frame();

  struct alignas(64) Count {
    std::atomic<std::uint64_t> lookups{0};
  };
  static constexpr std::size_t counts = 64;  ///< So that threads seldom share one.

  const std::size_t most_frames_;
  mutable std::mutex mutex_;  ///< Of all below but `lookups_`; never held while a source reads.
  std::vector<std::unique_ptr<Frame>> frames_;
  std::size_t hand_ = 0;
  TileStatistics statistics_;
  std::unique_ptr<Count[]> lookups_;
};

}  // namespace twinray

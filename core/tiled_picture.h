// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <utility>

#include "core/tile_cache.h"

namespace twinray {

/// A picture whose tiles are in a cache or in their source.
class TiledPicture {
 public:
  TiledPicture(const TileLayout& layout, std::shared_ptr<TileCache> cache,
               std::unique_ptr<const TileSource> source)
      : layout_(layout),
        cache_(std::move(cache)),
        source_(std::move(source)),
        slots_(std::make_unique<TileCache::Slot[]>(layout.tiles())) {}
  ~TiledPicture() { cache_->forget({slots_.get(), layout_.tiles()}); }
  TiledPicture(const TiledPicture&) = delete;
  TiledPicture& operator=(const TiledPicture&) = delete;

  const TileLayout& layout() const { return layout_; }
  Rgb texel(int level, int x, int y) const {
    const TileLayout::Place place = layout_.place(level, x, y);
    return cache_->texel(slots_[place.tile], *source_, place);
  }

 private:
  TileLayout layout_;
  std::shared_ptr<TileCache> cache_;
  std::unique_ptr<const TileSource> source_;
  std::unique_ptr<TileCache::Slot[]> slots_;  ///< One for each tile.
};

}  // namespace twinray

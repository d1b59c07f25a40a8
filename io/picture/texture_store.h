// SPDX-License-Identifier: Apache-2.0
// Where the pictures of a scene's surfaces are when memory for them is bounded: in tiles, in a temporary
// file.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>

#include "core/mip_map.h"

namespace twinray {

class ScratchFile;
struct TiledTexture;

/// What a store holds, and what its cache did.
struct TextureStatistics {
  std::size_t pictures = 0;         ///< In tiles; those of up to one tile are in memory.
  std::uint64_t picture_bytes = 0;  ///< What they and their mip-maps would take in memory.
  std::uint64_t most_bytes = 0;     ///< The bound.
  TileStatistics tiles;

  std::uint64_t bytes_read() const { return tiles.tiles_read * texels_a_tile * sizeof(Rgb); }
};

/// Of all pictures that it keeps at most so many bytes of tiles are in memory. Any number of threads may look
/// up texels; pictures are added by one.
class TextureStore {
 public:
  explicit TextureStore(std::uint64_t bytes);

  /// A mip-map of the same texels, written to a file without a name in the system's folder for temporary
  /// files (TMPDIR); itself if it is no larger than a tile. Throws Error where the file cannot be written.
  std::shared_ptr<const MipMap> keep(MipMap map);
  /// The same of texels that are in tiles, which stay where they are.
  std::shared_ptr<const MipMap> keep(TiledTexture texture);
  TextureStatistics statistics() const;

 private:
  std::shared_ptr<const MipMap> keep(const TileLayout& layout, std::unique_ptr<const TileSource> tiles,
                                     bool is_within_unit);

  std::shared_ptr<TileCache> cache_;
  std::shared_ptr<ScratchFile> file_;  ///< Null as long as nothing is in it.
  TextureStatistics kept_;
};

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "io/picture/texture_store.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "io/picture/tiled_texture.h"
#include "io/scratch_file.h"

namespace twinray {
namespace {

constexpr std::uint64_t tile_bytes = texels_a_tile * sizeof(Rgb);

/// Whether a picture is no larger than a tile.
bool is_small(const TileLayout& layout) { return layout.tiles() <= 2; }

/// Tiles that lie one behind the other from a place on.
class ScratchTiles final : public TileSource {
 public:
  ScratchTiles(std::shared_ptr<const ScratchFile> file, std::uint64_t begin)
      : file_(std::move(file)), begin_(begin) {}
  void read(std::uint32_t tile, std::span<Rgb> texels) const override {
    file_->read(begin_ + tile * tile_bytes, std::as_writable_bytes(texels));
  }

 private:
  std::shared_ptr<const ScratchFile> file_;
  std::uint64_t begin_;
};

/// Copies what a tile has of a level. `x` and `y`: of the tile's first texel.
void copy_part(const MipMap& map, const TileLayout& layout, int index, int x, int y, std::span<Rgb> tile) {
  const MipLevel level = map.level(index);
  for (int row = y; row < std::min(y + tile_side, level.height); ++row)
    for (int column = x; column < std::min(x + tile_side, level.width); ++column)
      tile[layout.place(index, column, row).texel] = level.at(column, row);
}

/// Appends all tiles, in their order. Returns where the first one is.
std::uint64_t write_tiles(const MipMap& map, const TileLayout& layout, ScratchFile& file) {
  const std::uint64_t begin = file.size();
  std::vector<Rgb> tile(texels_a_tile);
  const std::uint32_t last = layout.tiles() - 1;
  for (int index = 0; index < map.levels(); ++index) {
    const TileLayout::Level& level = layout.level(index);
    if (level.first_tile == last)
      copy_part(map, layout, index, 0, 0, tile);
    else
      for (int y = 0; y < level.height; y += tile_side)
        for (int x = 0; x < level.width; x += tile_side) {
          copy_part(map, layout, index, x, y, tile);
          file.append(std::as_bytes(std::span(tile)));
        }
  }
  file.append(std::as_bytes(std::span(tile)));
  return begin;
}

}  // namespace

TextureStore::TextureStore(std::uint64_t bytes) : cache_(std::make_shared<TileCache>(bytes)) {
  kept_.most_bytes = cache_->most_bytes();
}

std::shared_ptr<const MipMap> TextureStore::keep(MipMap map) {
  const MipLevel picture = map.level(0);
  const TileLayout layout(picture.width, picture.height);
  if (is_small(layout)) return std::make_shared<const MipMap>(std::move(map));
  if (!file_) file_ = std::make_shared<ScratchFile>();
  const std::uint64_t begin = write_tiles(map, layout, *file_);
  return keep(layout, std::make_unique<const ScratchTiles>(file_, begin), map.is_within_unit());
}

std::shared_ptr<const MipMap> TextureStore::keep(TiledTexture texture) {
  if (is_small(texture.layout)) return std::make_shared<const MipMap>(read_whole(texture));
  return keep(texture.layout, std::move(texture.tiles), texture.is_within_unit);
}

std::shared_ptr<const MipMap> TextureStore::keep(const TileLayout& layout,
                                                 std::unique_ptr<const TileSource> tiles,
                                                 bool is_within_unit) {
  ++kept_.pictures;
  for (int i = 0; i < layout.levels(); ++i)
    kept_.picture_bytes +=
        std::uint64_t(layout.level(i).width) * std::uint64_t(layout.level(i).height) * sizeof(Rgb);
  return std::make_shared<const MipMap>(
      std::make_unique<const TiledPicture>(layout, cache_, std::move(tiles)), is_within_unit);
}

TextureStatistics TextureStore::statistics() const {
  TextureStatistics statistics = kept_;
  statistics.tiles = cache_->statistics();
  return statistics;
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "io/picture/exr_tiled_file.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfTiledInputFile.h>

#include <array>
#include <mutex>

#include "io/picture/exr_attributes.h"
#include "io/picture/exr_failures.h"
#include "io/picture/exr_streams.h"

namespace twinray {
namespace {

constexpr std::array channel_names{"R", "G", "B"};

/// Whether these are all channels, and of 32-bit floats.
bool has_colors_alone(const Imf::Header& header) {
  Imf::ChannelList colors;
  for (const char* name : channel_names) colors.insert(name, Imf::Channel(Imf::FLOAT));
  return header.channels() == colors;
}

}  // namespace

struct TiledExr::File {
  DiskInput disk;
  Imf::TiledInputFile tiles;
  std::mutex mutex;  ///< Of the tiles: it is said where one goes, then it is read.

  explicit File(const std::string& path) : disk(path), tiles(disk, no_threads) {}
};

TiledExr::TiledExr(const std::string& path) : path_(path) {
  read_or_fail(path, [&] {
    file_ = std::make_unique<File>(path);
    const Imf::TiledInputFile& tiles = file_->tiles;
    if (!has_colors_alone(tiles.header()))
      throw Error(path + ": not a picture of three channels of 32-bit floats in tiles");
    const Imath::Box2i window = tiles.header().dataWindow();
    size_ = {window.max.x - window.min.x + 1, window.max.y - window.min.y + 1, tiles.numLevels(),
             int(tiles.tileXSize()), int(tiles.tileYSize())};
    metadata_ = texts_of(tiles.header());
  });
}

TiledExr::~TiledExr() = default;

void TiledExr::read(const Tile& tile, std::span<Rgb> texels) const {
  const std::array numbers{&texels[0].r, &texels[0].g, &texels[0].b};
  Imf::FrameBuffer buffer;
  for (std::size_t i = 0; i < channel_names.size(); ++i)
    buffer.insert(channel_names[i],
                  Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(numbers[i]), sizeof(Rgb),
                             sizeof(Rgb) * std::size_t(size_.tile_width), 1, 1, 0, true, true));
  read_or_fail(path_, [&] {
    const std::lock_guard lock(file_->mutex);
    file_->tiles.setFrameBuffer(buffer);
    file_->tiles.readTile(tile.column, tile.row, tile.level);
  });
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Pictures with their mip-maps in files of their own (.tx): OpenEXR in tiles of 64 x 64 texels, each of three
// 32-bit floats, with all levels, as core/mip_map.h makes them: nothing is left to compute, and a tile is
// read alone.
#pragma once
#include <memory>
#include <string>

#include "core/mip_map.h"
#include "core/tile_cache.h"
#include "io/picture/picture_meaning.h"

namespace twinray {

/// A file that is open.
struct TiledTexture {
  TileLayout layout;
  PictureMeaning meaning;  ///< Of the picture that it was made of.
  bool is_within_unit;     ///< MipMap::is_within_unit.
  std::unique_ptr<const TileSource> tiles;
};

/// Where the tiles of a picture of this meaning are: "wall.png.tx", of data "wall.png.data.tx", of numbers
/// "wall.png.number.tx", "wall.png.data.number.tx"; of one channel "wall.png.green.tx".
std::string tiled_name(const std::string& picture, const PictureMeaning& meaning);

/// Whether a file's name says that it is one of these: it ends in .tx.
bool is_tiled_name(const std::string& path);

/// Opens such a file. Throws Error, before memory is taken for texels, unless write_tiled made it, it is
/// whole, and has no more than most_texture_pixels.
TiledTexture open_tiled(const std::string& path);

/// All of its texels.
MipMap read_whole(const TiledTexture& texture);

/// Writes one, as write_file does. The same texels give the same bytes.
void write_tiled(const std::string& path, const MipMap& map, const PictureMeaning& meaning);

}  // namespace twinray

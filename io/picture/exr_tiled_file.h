// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <span>
#include <string>

#include "core/rgb.h"
#include "io/picture/image_metadata.h"

namespace twinray {

/// An OpenEXR file of one part in tiles, with smaller levels and channels R, G, B of 32-bit floats alone,
/// that is open. Any number of threads may read.
class TiledExr {
 public:
  struct Size {
    int width = 0, height = 0, levels = 0;
    int tile_width = 0, tile_height = 0;
  };
  struct Tile {
    int level = 0, column = 0, row = 0;
  };

  /// Its header was checked before. Throws Error.
  explicit TiledExr(const std::string& path);
  ~TiledExr();

  const Size& size() const { return size_; }
  const ImageMetadata& metadata() const { return metadata_; }
  /// All texels of a tile, row by row; what lies beside the level may be anything. Throws Error where the
  /// file does not have them.
  void read(const Tile& tile, std::span<Rgb> texels) const;

 private:
  struct File;

  std::string path_;
  std::unique_ptr<File> file_;
  Size size_;
  ImageMetadata metadata_;
};

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <vector>

#include "core/image.h"
#include "core/tiled_picture.h"

namespace twinray {

/// One level of a mip-map: a picture, wherever its pixels are.
class MipLevel {
 public:
  MipLevel(const Image& image) : width(image.width), height(image.height), image_(&image) {}
  MipLevel(const TiledPicture& tiles, int index)
      : width(tiles.layout().level(index).width),
        height(tiles.layout().level(index).height),
        tiles_(&tiles),
        index_(index) {}

  Rgb at(int x, int y) const { return image_ ? image_->at(x, y) : tiles_->texel(index_, x, y); }

  /// Asks memory for a pixel; nothing of one in tiles.
  void prefetch(int x, int y) const {
    if (!image_) return;
    const Rgb* const pixel = &image_->at(x, y);
    // GCC takes a function that does no more than ask for memory for one without an effect, and leaves it
    // out.
    asm volatile("" : : "r"(pixel));
    __builtin_prefetch(pixel);
  }

  int width = 0, height = 0;

 private:
  const Image* image_ = nullptr;  ///< Null: in tiles.
  const TiledPicture* tiles_ = nullptr;
  int index_ = 0;
};

/// A picture and its smaller copies, each half as wide and high (rounded down, at least one pixel) as the one
/// before, down to one pixel. A pixel is the mean of the area that it covers of the level before (box
/// filter), so that every level has the mean of the picture. Its pixels are in memory, or in tiles of which
/// some are.
class MipMap {
 public:
  /// At least one pixel.
  explicit MipMap(Image picture);
  /// The levels are those that the first one would be given.
  explicit MipMap(std::vector<Image> levels);
  /// Not null; the levels are those of such a picture.
  MipMap(std::unique_ptr<const TiledPicture> tiles, bool is_within_unit)
      : tiles_(std::move(tiles)), is_within_unit_(is_within_unit) {}

  int levels() const { return tiles_ ? tiles_->layout().levels() : int(levels_.size()); }
  /// 0: the picture itself. The mip-map must outlive it.
  MipLevel level(int index) const {
    return tiles_ ? MipLevel(*tiles_, index) : MipLevel(levels_[std::size_t(index)]);
  }
  /// A copy of a level.
  Image image(int index) const;
  bool is_in_memory() const { return !tiles_; }
  /// Whether all channels of all texels lie in [0, 1].
  bool is_within_unit() const { return is_within_unit_; }
  /// Of all pixels of the picture.
  Rgb mean() const;

 private:
  std::vector<Image> levels_;
  std::unique_ptr<const TiledPicture> tiles_;  ///< Null: all levels are in memory.
  bool is_within_unit_;
};

/// The same texels, all of them in memory: looking them up neither locks nor allocates.
std::shared_ptr<const MipMap> in_memory(const std::shared_ptr<const MipMap>& map);

}  // namespace twinray

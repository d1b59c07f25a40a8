// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "core/image.h"

namespace twinray {

/// A picture and its smaller copies, each half as wide and high (rounded down, at least one pixel) as the one
/// before, down to one pixel. A pixel is the mean of the area that it covers of the level before (box
/// filter), so that every level has the mean of the picture.
class MipMap {
 public:
  /// At least one pixel.
  explicit MipMap(Image picture);

  int levels() const { return int(levels_.size()); }
  /// 0: the picture itself.
  const Image& level(int index) const { return levels_[std::size_t(index)]; }

 private:
  std::vector<Image> levels_;
};

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/image.h"

namespace twinray::test {

/// A picture of one colour.
inline Image filled_image(int width, int height, const Rgb& color) {
  Image image(width, height);
  for (Rgb& pixel : image.pixels) pixel = color;
  return image;
}

}  // namespace twinray::test

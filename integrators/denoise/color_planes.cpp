// SPDX-License-Identifier: Apache-2.0
#include "integrators/denoise/color_planes.h"

namespace twinray {

Image image_of(std::span<const Plane> color) {
  Image image(color[0].width, color[0].height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = {color[0].values[i], color[1].values[i], color[2].values[i]};
  return image;
}

Color color_of(const Image& image) {
  const Plane empty(image.width, image.height);
  Color color{empty, empty, empty};
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const auto& [r, g, b] = image.pixels[i];
    color[0].values[i] = r, color[1].values[i] = g, color[2].values[i] = b;
  }
  return color;
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "core/texture_model.h"

namespace twinray::test {

/// Red grows to the right, green upwards, blue is 1.
inline std::shared_ptr<const MipMap> ramp(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.at(x, y) = {float(x), float(height - 1 - y), 1};
  return std::make_shared<const MipMap>(image);
}

inline const Texture red{"red", ConstantTexture{{1, 0, 0}}}, half{"half", ConstantTexture{{0.5f, 0.25f, 1}}};
inline constexpr Rgb half_color{0.5f, 0.25f, 1};

}  // namespace twinray::test

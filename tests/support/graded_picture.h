// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "core/mip_map.h"

namespace twinray::test {

/// No two pixels are alike; of up to ten, all channels lie in [0, 1].
inline std::shared_ptr<const MipMap> graded_picture(int width, int height) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = {0.1f * float(i), 0.05f * float(i) + 0.01f, 0.9f - 0.1f * float(i)};
  return std::make_shared<const MipMap>(std::move(image));
}

}  // namespace twinray::test

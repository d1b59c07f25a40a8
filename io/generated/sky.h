// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "core/image.h"
#include "core/light.h"

namespace twinray::generated {

/// White at the horizon, blue above; brown below it.
inline EnvironmentLight make_sky() {
  auto map = std::make_shared<Image>(16, 16);
  for (int y = 0; y < map->height; ++y)
    for (int x = 0; x < map->width; ++x) {
      const float up = 1 - (float(y) + 0.5f) / 8;
      map->at(x, y) =
          up > 0 ? Rgb{1.1f - 0.8f * up, 1.2f - 0.5f * up, 1.3f - 0.1f * up} : Rgb{0.1f, 0.08f, 0.05f};
    }
  return {map};
}

}  // namespace twinray::generated

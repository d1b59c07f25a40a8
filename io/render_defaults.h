// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "core/pixel_filter.h"

namespace twinray {

/// What a scene file says about its picture: it holds where nobody asks for something else.
struct RenderDefaults {
  struct Resolution {
    int width, height;
  };
  std::optional<Resolution> resolution;    ///< In pixels.
  std::optional<std::array<int, 4>> crop;  ///< x, y, width and height of a part of the resolution.
  std::optional<std::uint32_t> samples;    ///< Per pixel.
  std::optional<int> max_depth;            ///< Scattering events.
  std::optional<PixelFilter> filter;
};

}  // namespace twinray

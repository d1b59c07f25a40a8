// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/pixel_filter.h"

namespace twinray {

/// When what moves is seen, in seconds.
struct Shutter {
  double open = 0, close = 0;

  double length() const { return close - open; }
  /// At a part of the time that it is open.
  double at(double part) const { return open + part * length(); }
  bool operator==(const Shutter&) const = default;
};

/// Of light that displays may show as white.
inline constexpr double least_white_kelvin = 2000, most_white_kelvin = 25000;

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
  std::optional<Shutter> shutter;  ///< Of a scene in which something moves.
  /// Displays show daylight of this temperature as white: kelvin, in white_kelvins.
  std::optional<double> daylight_kelvin;

  /// The crop of a picture of this size: the same part of it, of a pixel at least.
  std::optional<std::array<int, 4>> crop_of(const Resolution& size) const {
    if (!crop || !resolution) return crop;
    const auto [x0, x1] = scaled((*crop)[0], (*crop)[2], resolution->width, size.width);
    const auto [y0, y1] = scaled((*crop)[1], (*crop)[3], resolution->height, size.height);
    return std::array{x0, y0, x1 - x0, y1 - y0};
  }

 private:
  /// From and to of a part of `old` pixels, of `anew` ones.
  static std::pair<int, int> scaled(int first, int count, int old, int anew) {
    const auto at = [&](int pixel) { return int((std::int64_t{pixel} * anew + old / 2) / old); };
    const int from = std::min(at(first), anew - 1);
    return {from, std::max(at(first + count), from + 1)};
  }
};

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// How two pictures differ: by how much over all, in which channel, and where.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "check/picture_error.h"
#include "core/image.h"

namespace twinray {

/// Of one channel, or of all three together.
struct ChannelDifference {
  SquaredError squared;
  double mean = 0;            ///< Of picture - reference: above 0 the picture is brighter.
  double reference_mean = 0;  ///< Of the reference alone.
};

/// Where one channel of one pixel differs.
struct PixelDifference {
  int x = 0, y = 0;
  std::size_t channel = 0;
  double value = 0;  ///< Picture - reference.
};

struct PictureDifference {
  ChannelDifference all;
  std::array<ChannelDifference, 3> channels;  ///< Red, green, blue.
  std::size_t differing_pixels = 0;           ///< That are not equal.
  PixelDifference largest;                    ///< The first of the largest.
};

/// Throws Error unless both pictures have the same size, of a pixel at least.
PictureDifference picture_difference(const Image& picture, const Image& reference);

/// The mean squared error of a tile over its pixels and channels, and the mean signed one of luminance.
struct TileDifference {
  PixelRect tile;
  double mse = 0, luminance = 0;
};

/// Those that differ most, up to `count`, by falling mean squared error; equal ones are left out.
std::vector<TileDifference> largest_differences(const Image& picture, const Image& reference,
                                                std::size_t count, int tile_edge = 16);

/// 10 log10(255^2 / mean squared error) of 8-bit pictures, in decibels; none for equal ones. Throws Error
/// unless both have the same size.
std::optional<double> peak_signal_to_noise(const ByteImage& picture, const ByteImage& reference);

}  // namespace twinray

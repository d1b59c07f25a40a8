// SPDX-License-Identifier: Apache-2.0
// Numbers as colours: a scale whose lightness grows evenly, and its legend.
#pragma once
#include <array>
#include <cstdint>

#include "core/image.h"

namespace twinray {

/// The linear colour of x in [0, 1] (clamped; not-a-number counts as 0): from dark violet over blue and green
/// to light yellow. In OKLab (Ottosson 2020) the lightness grows linearly from 0.2 to 0.95 and the hue turns
/// evenly; the chroma is the largest up to 0.15 that sRGB holds.
Rgb scale_color(float x);

/// The sRGB bytes of x in [-1, 1] (clamped; not-a-number counts as 0): from blue over white (0) to red.
std::array<std::uint8_t, 3> signed_color(double x);

/// The least of 5, 10, 20, 50, 100, ... that is no smaller than any red component of the image, which must be
/// at most 10^9: where a scale ends whose five parts are whole numbers.
std::uint32_t scale_end(const Image& values);

/// Each red component as the colour of its share of `end` > 0.
ByteImage scaled_image(const Image& values, std::uint32_t end);

/// A strip of the scale from 0 (below) to `end` (above), with six numbers beside it; 116 x 221 pixels.
ByteImage legend_image(std::uint32_t end);

}  // namespace twinray

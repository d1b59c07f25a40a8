// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/film.h"
#include "core/rgb.h"

namespace twinray {

/// A picture of linear colours, row by row from the top left.
struct Image {
  int width = 0, height = 0;
  std::vector<Rgb> pixels;

  Image() = default;
  /// Of one colour.
  Image(int w, int h, const Rgb& color = {})
      : width(w), height(h), pixels(std::size_t(w) * std::size_t(h), color) {}
  Rgb& at(int x, int y) { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
  const Rgb& at(int x, int y) const { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
};

/// Of all pixels; there is at least one.
Rgb mean_of(const Image& image);

/// A picture of 8-bit channels r, g, b, row by row from the top left.
struct ByteImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bytes;  ///< 3 width height
};

/// The mean colours, one pixel for each of the film's window.
Image mean_image(const Film& film);

/// How many samples each pixel took, as colours: from blue (0) over green (half of `most`) to red (`most`).
ByteImage sample_rate_image(const Film& film, std::uint32_t most);

/// A colour on the scale from blue (0) over green (0.5) to red (1), bytes truncated as CS184's program does.
std::array<std::uint8_t, 3> rate_color(float rate);

/// Linear radiance as sRGB (IEC 61966-2-1), clipped at 1, rounded to the nearest byte. Not-a-number gives 0.
std::uint8_t encode_srgb(float linear);
ByteImage encode_srgb(const Image& image);

}  // namespace twinray

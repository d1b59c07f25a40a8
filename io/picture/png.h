// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "core/image.h"
#include "io/picture/image_metadata.h"

namespace twinray {

/// The bytes of an 8-bit sRGB PNG. Metadata of the name "DateTime" ("2023:11:14 22:13:20") is the picture's
/// time; all other is text: Latin-1 as tEXt, what is beyond ASCII as iTXt of UTF-8. The names must have 1 to
/// 79 characters. Throws Error where PNG's library refuses.
std::vector<unsigned char> encode_png(const ByteImage& image, const ImageMetadata& metadata);

/// A picture of 8-bit channels r, g, b and alpha, row by row from the top left.
struct AlphaImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bytes;  ///< 4 width height
};

/// The bytes of such a PNG, which says that its colours are sRGB's.
std::vector<unsigned char> encode_png(const AlphaImage& image);

}  // namespace twinray

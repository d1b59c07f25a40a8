// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "core/image.h"
#include "io/image_metadata.h"

namespace twinray {

/// The bytes of an 8-bit sRGB PNG. Metadata of the name "DateTime" ("2023:11:14 22:13:20") is the picture's
/// time; all other is text: Latin-1 as tEXt, what is beyond ASCII as iTXt of UTF-8. The names must have 1 to
/// 79 characters. Throws Error where PNG's library refuses.
std::vector<unsigned char> encode_png(const ByteImage& image, const ImageMetadata& metadata);

}  // namespace twinray

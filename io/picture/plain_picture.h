// SPDX-License-Identifier: Apache-2.0
// Two formats so plain that they are read here: PFM (floats of one or three channels) and TGA (8 bits a
// channel, packed in runs or not; no palettes).
#pragma once
#include <string>

#include "core/image.h"
#include "io/picture/picture_bytes.h"

namespace twinray {

/// The size that the header states. Throws Error where it is none.
PictureSize pfm_size(const PictureBytes& picture);
PictureSize tga_size(const PictureBytes& picture);

/// All pixels, as they are stored: floats, or 8 bits as [0, 1]. Throws Error where the file is cut off, or of
/// a kind that is not read.
Image decode_pfm(const PictureBytes& picture);
Image decode_tga(const PictureBytes& picture);
/// The alpha channel of a TGA picture, as grey; 1 where there is none.
Image decode_tga_alpha(const PictureBytes& picture);

/// The bytes of a PFM file of three channels, or of one, red: little-endian floats, the lowest row first.
std::string encode_pfm(const Image& image, int channels = 3);

}  // namespace twinray

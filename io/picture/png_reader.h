// SPDX-License-Identifier: Apache-2.0
// PNG pictures, read by PNG's own library. Each function throws Error where the file cannot be read.
#pragma once
#include "core/image.h"
#include "io/picture/image_metadata.h"
#include "io/picture/picture_header.h"

namespace twinray {

/// Red, green and blue as they are stored, of up to 8 bits or of 16, as [0, 1]; or grey. An alpha changes
/// nothing.
Image decode_png(const PictureBytes& picture, const HeaderCheck& check);
/// The alpha as grey, 1 where there is none.
Image decode_png_alpha(const PictureBytes& picture, const HeaderCheck& check);
/// The texts before the pixels, and the time that the picture was changed at as "DateTime".
ImageMetadata decode_png_metadata(const PictureBytes& picture, const HeaderCheck& check);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// WebP pictures, read by WebP's own library. Each function throws Error where the file cannot be read.
#pragma once
#include "core/image.h"
#include "io/picture/picture_bytes.h"

namespace twinray {

/// The size that the header states. Of a picture that moves there is none that is read.
PictureSize webp_size(const PictureBytes& picture);
/// Red, green and blue of 8 bits as they are stored, as [0, 1]. An alpha changes nothing.
Image decode_webp(const PictureBytes& picture);
/// The alpha as grey, 1 where there is none.
Image decode_webp_alpha(const PictureBytes& picture);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// JPEG pictures, read by libjpeg.
#pragma once
#include "core/image.h"
#include "io/picture/picture_header.h"

namespace twinray {

/// The colours, or the grey, as they are stored, as [0, 1]. Those of printers (CMYK) are multiplied by their
/// black, as OpenImageIO does it. Throws Error where the file cannot be read, or its data are damaged.
Image decode_jpeg(const PictureBytes& picture, const HeaderCheck& check);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Radiance pictures (HDR).
#pragma once
#include "core/image.h"
#include "io/picture/picture_header.h"

namespace twinray {

/// The radiance, row by row from the top left wherever the file begins, without its EXPOSURE. Throws Error
/// where the file cannot be read, and where its rows are columns.
Image decode_hdr(const PictureBytes& picture, const HeaderCheck& check);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// A picture that stands in the page itself, as an address made of its bytes.
#pragma once
#include <string>
#include <string_view>

#include "core/image.h"

namespace twinray::html {

/// The address of a picture that stands in the page itself: "data:image/png;base64,...", by the ending of its
/// name: .png, .jpg, .jpeg, .gif or .webp. Throws Error for another ending, or where the file cannot be read.
std::string picture_address(const std::string& path);

/// The same of pixels, as a PNG.
std::string picture_address(const ByteImage& image);

/// Bytes as text of 64 characters (RFC 4648, section 4).
std::string base64(std::string_view bytes);

}  // namespace twinray::html

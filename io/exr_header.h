// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

namespace twinray {

/// Throws Error unless the file begins with the header of an OpenEXR picture whose sizes are in range and fit
/// the file's length: the library takes memory by them as soon as it opens the file.
void check_exr_header(const std::string& path);

/// How many pixels a byte of a file can stand for at most, with room: a black PNG of one bit a pixel has 8 *
/// 1032 of them, a JPEG no more than 64 a bit; OpenEXR and Radiance have no such bound, and no use for more.
inline constexpr long long pixels_a_png_byte = 1 << 14, pixels_a_jpeg_byte = 1 << 10, pixels_a_byte = 1 << 15;

/// Throws Error where a picture of this size cannot be in its file, or has more than 2^28 pixels, or none.
void check_picture_size(const std::string& path, long long width, long long height, long long most_a_byte);

}  // namespace twinray

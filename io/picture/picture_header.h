// SPDX-License-Identifier: Apache-2.0
// What a picture's file says of itself, read before a library opens it: libraries take memory by it at once.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "io/picture/picture_bytes.h"

namespace twinray {

enum class PictureFormat { exr, hdr, png, jpeg, pfm, tga, webp };

/// The ending of a name with its dot, in small letters: ".png".
std::string picture_ending(const std::string& path);

/// The format of a file by its ending, none where that is of no picture that is read.
std::optional<PictureFormat> known_picture_format(const std::string& path);

/// The format of a file by its ending. Throws Error where it is none that is read.
PictureFormat picture_format(const std::string& path);

/// What a file begins with at most that tells its format.
inline constexpr std::size_t signature_bytes = 12;
/// The format that a picture's first bytes tell: PNG, JPEG, WebP or OpenEXR; none where they are of another.
std::optional<PictureFormat> signed_format(std::string_view bytes);

/// The size that the header of a picture states. Throws Error unless the header is there, of this format, and
/// its sizes are in range and fit the number of bytes.
PictureSize check_picture_header(PictureFormat format, const PictureBytes& picture);

/// The same for OpenEXR, which may hold several pictures: the size of the largest.
PictureSize check_exr_header(const PictureBytes& picture);

/// What an OpenEXR picture begins with that says whether it has parts.
inline constexpr std::size_t exr_flags_end = 8;
bool has_exr_parts(std::string_view begin);
/// What is to be told of an OpenEXR picture whose header is checked: how many parts it has where there are
/// several, and which one is read; else "".
std::string unread_exr_parts(const PictureBytes& picture);

/// What a picture's reader finds in its header.
struct PictureHeader {
  int width = 0, height = 0, channels = 0;
};

/// Sees it before memory is taken for pixels, and throws Error to refuse the picture.
using HeaderCheck = std::function<void(const PictureHeader&)>;

/// Throws Error where a picture of this size has more than 2^28 pixels, or none, or more than so many bytes
/// of this format can hold.
void check_picture_size(PictureFormat format, const PictureSize& size, const PictureBytes& picture);

}  // namespace twinray

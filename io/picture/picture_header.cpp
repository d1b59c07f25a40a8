// SPDX-License-Identifier: Apache-2.0
#include "io/picture/picture_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "core/error.h"
#include "io/lower_case.h"
#include "io/picture/plain_picture.h"
#include "io/picture/webp_reader.h"

namespace twinray {
namespace {

constexpr long long max_pixels = 1ll << 28;
constexpr long long small_picture = 1ll << 16;  ///< Pixels that any file may have.

/// How many pixels a byte of a file can stand for at most, with room: a black PNG of one bit a pixel has 8 *
/// 1032 of them, a JPEG no more than 64 a bit; OpenEXR and Radiance have no such bound, and no use for more.
long long most_pixels_a_byte(PictureFormat format) {
  switch (format) {
    case PictureFormat::png:
      return 1 << 14;
    case PictureFormat::jpeg:
      return 1 << 10;
    case PictureFormat::webp:  // An even colour takes none.
      return 1 << 20;
    case PictureFormat::tga:  // runs of 128
      return 1 << 7;
    case PictureFormat::pfm:
      return 1;
    default:
      return 1 << 15;
  }
}

constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n", exr_signature = "\x76\x2f\x31\x01",
                           jpeg_signature = "\xff\xd8";

/// A number of so many bytes, the most significant first.
long long big_endian(std::string_view bytes) {
  long long number = 0;
  for (const char byte : bytes) number = number << 8 | static_cast<unsigned char>(byte);
  return number;
}

/// Signature, then the chunk IHDR: its length, its name, width and height ("PNG Specification", W3C, 11.2.2).
PictureSize png_size(const PictureBytes& picture) {
  const std::string_view bytes = picture.bytes;
  if (!bytes.starts_with(png_signature)) fail_picture(picture, "it does not begin as a PNG picture does");
  if (bytes.size() < 24) fail_picture(picture, "its header is cut off");
  if (bytes.substr(12, 4) != "IHDR") fail_picture(picture, "its header does not come first");
  return {big_endian(bytes.substr(16, 4)), big_endian(bytes.substr(20, 4))};
}

bool starts_frame(unsigned char marker) {
  return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

bool stands_alone(unsigned char marker) { return marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8); }

/// Segments, each a byte 0xff, a marker and mostly its length; the start of a frame has precision, height and
/// width behind that (ITU-T T.81, annex B). What stands between segments is passed over, as libjpeg does.
PictureSize jpeg_size(const PictureBytes& picture) {
  const std::string_view bytes = picture.bytes;
  if (!bytes.starts_with(jpeg_signature)) fail_picture(picture, "it does not begin as a JPEG picture does");
  for (std::size_t at = 2; (at = bytes.find('\xff', at)) != bytes.npos;) {
    at = bytes.find_first_not_of('\xff', at);
    if (at == bytes.npos) break;
    const auto marker = static_cast<unsigned char>(bytes[at++]);
    if (marker == 0 || stands_alone(marker)) continue;
    if (bytes.size() - at < 7) break;
    if (starts_frame(marker))
      return {big_endian(bytes.substr(at + 5, 2)), big_endian(bytes.substr(at + 3, 2))};
    at += std::size_t(big_endian(bytes.substr(at, 2)));
  }
  fail_picture(picture, "its header is cut off");
}

std::string_view next_word(std::string_view& text) {
  const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
  const std::size_t end = std::min(text.find(' ', begin), text.size());
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

/// Reads "-Y 480", of whatever axis and sign, from a line.
bool read_side(std::string_view& line, PictureSize& size) {
  const std::string_view axis = next_word(line), word = next_word(line);
  if (axis.size() != 2 || (axis[1] != 'X' && axis[1] != 'Y')) return false;
  long long& side = axis[1] == 'X' ? size.width : size.height;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), side);
  return error == std::errc{} && end == word.data() + word.size();
}

/// Lines of text up to an empty one, then the size as "-Y 480 +X 640" (Ward, "Real Pixels", Graphics Gems
/// II).
PictureSize hdr_size(const PictureBytes& picture) {
  const std::string_view bytes = picture.bytes;
  if (!bytes.starts_with("#?")) fail_picture(picture, "it does not begin as a Radiance picture does");
  const std::size_t empty = bytes.find("\n\n");
  const std::size_t end = empty == bytes.npos ? empty : bytes.find('\n', empty + 2);
  if (end == bytes.npos) fail_picture(picture, "its header is cut off");
  std::string_view line = bytes.substr(empty + 2, end - empty - 2);
  PictureSize size;
  if (!read_side(line, size) || !read_side(line, size))
    fail_picture(picture, "its header states no size such as -Y 480 +X 640");
  return size;
}

PictureSize stated_size(PictureFormat format, const PictureBytes& picture) {
  switch (format) {
    case PictureFormat::png:
      return png_size(picture);
    case PictureFormat::jpeg:
      return jpeg_size(picture);
    case PictureFormat::hdr:
      return hdr_size(picture);
    case PictureFormat::pfm:
      return pfm_size(picture);
    case PictureFormat::tga:
      return tga_size(picture);
    case PictureFormat::webp:
      return webp_size(picture);
    default:
      return check_exr_header(picture);
  }
}

}  // namespace

std::string picture_ending(const std::string& path) {
  return lower_case(std::filesystem::path(path).extension().string());
}

std::optional<PictureFormat> known_picture_format(const std::string& path) {
  const std::string ending = picture_ending(path);
  if (ending == ".exr") return PictureFormat::exr;
  if (ending == ".hdr") return PictureFormat::hdr;
  if (ending == ".png") return PictureFormat::png;
  if (ending == ".jpg" || ending == ".jpeg") return PictureFormat::jpeg;
  if (ending == ".pfm") return PictureFormat::pfm;
  if (ending == ".tga") return PictureFormat::tga;
  if (ending == ".webp") return PictureFormat::webp;
  return std::nullopt;
}

std::optional<PictureFormat> signed_format(std::string_view bytes) {
  if (bytes.starts_with(png_signature)) return PictureFormat::png;
  if (bytes.starts_with(jpeg_signature)) return PictureFormat::jpeg;
  if (bytes.starts_with("RIFF") && bytes.size() >= 12 && bytes.substr(8, 4) == "WEBP")
    return PictureFormat::webp;
  if (bytes.starts_with(exr_signature)) return PictureFormat::exr;
  return std::nullopt;
}

PictureFormat picture_format(const std::string& path) {
  if (const auto format = known_picture_format(path)) return *format;
  throw Error(
      fmt::format("{}: not a picture that can be read; valid endings are .exr, .hdr, .png, .jpg, .jpeg, "
                  ".pfm, .tga, .webp",
                  path));
}

PictureSize check_picture_header(PictureFormat format, const PictureBytes& picture) {
  const PictureSize size = stated_size(format, picture);
  check_picture_size(format, size, picture);
  return size;
}

void check_picture_size(PictureFormat format, const PictureSize& size, const PictureBytes& picture) {
  const auto [width, height] = size;
  if (width < 1 || height < 1 || width > max_pixels || height > max_pixels || width * height > max_pixels)
    throw Error(fmt::format("{}: {} x {} pixels; valid are up to 2^28", picture.path, width, height));
  const long long bytes = static_cast<long long>(picture.bytes.size());
  if (width * height > small_picture && (width * height - small_picture) / most_pixels_a_byte(format) > bytes)
    throw Error(
        fmt::format("{}: says that it has {} x {} pixels, and is a file of {} bytes: it is cut off, or no "
                    "picture",
                    picture.path, width, height, bytes));
}

}  // namespace twinray

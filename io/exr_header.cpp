// SPDX-License-Identifier: Apache-2.0
// The header of an OpenEXR file ("OpenEXR File Layout", openexr.com): magic number, version and flags, then
// attributes, each of a name, a type, a size and so many bytes; an empty name ends them. A file of several
// parts has such a list for each, and an empty one behind the last.
#include <fmt/format.h>

#include <cstdint>

#include "io/picture_header.h"

namespace twinray {
namespace {

constexpr std::uint32_t magic = 20000630;
constexpr std::uint32_t flag_deep = 1u << 11, flag_parts = 1u << 12;
constexpr std::size_t longest_name = 255;
constexpr std::uint64_t longest_tile = 4096;  ///< The largest that is read, in pixels of a side.

class HeaderReader {
 public:
  explicit HeaderReader(const PictureBytes& picture) : picture_(picture), rest_(picture.bytes) {}

  PictureSize read() {
    if (number() != magic) fail("it does not begin as an OpenEXR picture does");
    const std::uint32_t flags = number();
    if (flags & flag_deep) fail("it is a deep picture, which is not read");
    do read_part();
    while ((flags & flag_parts) && !rest_.starts_with('\0'));
    return largest_;
  }

 private:
  void read_part() {
    bool has_window = false;
    for (std::string_view attribute = name(); !attribute.empty(); attribute = name()) {
      name();  // its type
      const std::uint32_t size = number();
      if (size > rest_.size()) fail(fmt::format("its {} is longer than the file", attribute));
      const std::string_view behind = rest_.substr(size);
      if (attribute == "dataWindow" && size == 16) has_window = true, read_window();
      if (attribute == "tiles" && size == 9) read_tile();
      rest_ = behind;
    }
    if (!has_window) fail("it has no dataWindow");
  }

  void read_window() {
    const long long x0 = std::int32_t(number()), y0 = std::int32_t(number());
    const long long x1 = std::int32_t(number()), y1 = std::int32_t(number());
    const PictureSize size{x1 - x0 + 1, y1 - y0 + 1};
    check_picture_size(PictureFormat::exr, size, picture_);
    if (size.width * size.height > largest_.width * largest_.height) largest_ = size;
  }

  void read_tile() {
    const std::uint64_t width = number(), height = number();
    if (width < 1 || height < 1 || width > longest_tile || height > longest_tile)
      fail(fmt::format("its tiles have {} x {} pixels; valid are up to {} x {}", width, height, longest_tile,
                       longest_tile));
  }

  /// The next 4 bytes, the least significant first.
  std::uint32_t number() {
    if (rest_.size() < 4) fail("its header is cut off");
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(rest_[i]);
    rest_.remove_prefix(4);
    return value;
  }

  std::string_view name() {
    const std::size_t length = rest_.substr(0, longest_name + 1).find('\0');
    if (length == rest_.npos)
      fail(rest_.size() > longest_name ? "a name in its header is too long" : "its header is cut off");
    const std::string_view text = rest_.substr(0, length);
    rest_.remove_prefix(length + 1);
    return text;
  }

  [[noreturn]] void fail(const std::string& reason) const { fail_picture(picture_, reason); }

  const PictureBytes& picture_;
  std::string_view rest_;
  PictureSize largest_;
};

}  // namespace

PictureSize check_exr_header(const PictureBytes& picture) { return HeaderReader(picture).read(); }

}  // namespace twinray

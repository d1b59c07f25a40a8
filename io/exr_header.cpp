// SPDX-License-Identifier: Apache-2.0
// The header of an OpenEXR file ("OpenEXR File Layout", openexr.com): magic number, version and flags, then
// attributes, each of a name, a type, a size and so many bytes; an empty name ends them. A file of several
// parts has such a list for each, and an empty one behind the last.
#include "io/exr_header.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/error.h"

namespace twinray {
namespace {

constexpr std::uint32_t magic = 20000630;
constexpr std::uint32_t flag_deep = 1u << 11, flag_parts = 1u << 12;
constexpr std::size_t longest_name = 255;
constexpr std::uint64_t longest_tile = 4096;  ///< The largest that is read, in pixels of a side.

constexpr long long max_pixels = 1ll << 28;
constexpr long long small_picture = 1ll << 16;  ///< Pixels that any file may have.

class HeaderReader {
 public:
  explicit HeaderReader(const std::string& path)
      : path_(path), file_(path, std::ios::binary), length_(std::filesystem::file_size(path)) {}

  void read() {
    if (number() != magic) fail("it does not begin as an OpenEXR picture does");
    const std::uint32_t flags = number();
    if (flags & flag_deep) fail("it is a deep picture, which is not read");
    do read_part();
    while ((flags & flag_parts) && file_.peek() != 0);
  }

 private:
  void read_part() {
    bool has_window = false;
    for (std::string attribute = name(); !attribute.empty(); attribute = name()) {
      name();  // its type
      const std::uint64_t size = number(), begin = std::uint64_t(file_.tellg());
      if (size > length_ - begin) fail(fmt::format("its {} is longer than the file", attribute));
      if (attribute == "dataWindow" && size == 16) has_window = true, read_window();
      if (attribute == "tiles" && size == 9) read_tile();
      file_.seekg(std::streamoff(begin + size));
    }
    if (!has_window) fail("it has no dataWindow");
  }

  void read_window() {
    const long long x0 = std::int32_t(number()), y0 = std::int32_t(number());
    const long long x1 = std::int32_t(number()), y1 = std::int32_t(number());
    check_picture_size(path_, x1 - x0 + 1, y1 - y0 + 1, pixels_a_byte);
  }

  void read_tile() {
    const std::uint64_t width = number(), height = number();
    if (width < 1 || height < 1 || width > longest_tile || height > longest_tile)
      fail(fmt::format("its tiles have {} x {} pixels; valid are up to {} x {}", width, height, longest_tile,
                       longest_tile));
  }

  std::uint32_t number() {
    unsigned char bytes[4];
    if (!file_.read(reinterpret_cast<char*>(bytes), sizeof bytes)) fail("its header is cut off");
    return bytes[0] | std::uint32_t(bytes[1]) << 8 | std::uint32_t(bytes[2]) << 16 |
           std::uint32_t(bytes[3]) << 24;
  }

  std::string name() {
    std::string text;
    for (int byte = file_.get(); byte != 0; byte = file_.get()) {
      if (byte == std::ifstream::traits_type::eof()) fail("its header is cut off");
      if (text.size() == longest_name) fail("a name in its header is too long");
      text += char(byte);
    }
    return text;
  }

  [[noreturn]] void fail(const std::string& reason) const {
    throw Error(fmt::format("{}: cannot be read: {}", path_, reason));
  }

  const std::string& path_;
  std::ifstream file_;
  std::uint64_t length_;
};

}  // namespace

void check_exr_header(const std::string& path) { HeaderReader(path).read(); }

void check_picture_size(const std::string& path, long long width, long long height, long long most_a_byte) {
  if (width < 1 || height < 1 || width > max_pixels || height > max_pixels || width * height > max_pixels)
    throw Error(fmt::format("{}: {} x {} pixels; valid are up to 2^28", path, width, height));
  const long long bytes = static_cast<long long>(std::filesystem::file_size(path));
  if (width * height > small_picture && (width * height - small_picture) / most_a_byte > bytes)
    throw Error(
        fmt::format("{}: says that it has {} x {} pixels, and is a file of {} bytes: it is cut off, or no "
                    "picture",
                    path, width, height, bytes));
}

}  // namespace twinray

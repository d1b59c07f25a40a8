// SPDX-License-Identifier: Apache-2.0
// The header of an OpenEXR file ("OpenEXR File Layout", openexr.com): magic number, version and flags, then
// attributes, each of a name, a type, a size and so many bytes; an empty name ends them. A file of several
// parts has such a list for each, and an empty one behind the last. The library takes the sizes of most
// values from their types, and reads on behind those: a size that is another would lead it elsewhere than us.
#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "io/picture/picture_header.h"

namespace twinray {
namespace {

constexpr std::uint32_t magic = 20000630;
constexpr std::uint32_t flag_deep = 1u << 11, flag_parts = 1u << 12;
constexpr std::size_t longest_name = 255;
constexpr std::uint64_t longest_tile = 4096;  ///< The largest that is read, in pixels of a side.

/// The bytes of a value of this type, if it has always as many.
std::optional<std::uint32_t> size_of_type(std::string_view type) {
  static const std::map<std::string_view, std::uint32_t> known{{"box2i", 16},
                                                               {"box2f", 16},
                                                               {"chromaticities", 32},
                                                               {"compression", 1},
                                                               {"deepImageState", 1},
                                                               {"double", 8},
                                                               {"envmap", 1},
                                                               {"float", 4},
                                                               {"int", 4},
                                                               {"keycode", 28},
                                                               {"lineOrder", 1},
                                                               {"m33f", 36},
                                                               {"m33d", 72},
                                                               {"m44f", 64},
                                                               {"m44d", 128},
                                                               {"rational", 8},
                                                               {"tiledesc", 9},
                                                               {"timecode", 8},
                                                               {"v2i", 8},
                                                               {"v2f", 8},
                                                               {"v2d", 16},
                                                               {"v3i", 12},
                                                               {"v3f", 12},
                                                               {"v3d", 24}};
  const auto found = known.find(type);
  return found == known.end() ? std::nullopt : std::optional(found->second);
}

class HeaderReader {
 public:
  explicit HeaderReader(const PictureBytes& picture) : picture_(picture), rest_(picture.bytes) {}

  /// How many pictures the file has, and the name of the first one; once it is read.
  std::size_t parts() const { return parts_; }
  const std::string& first_name() const { return first_name_; }

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
    ++parts_;
    for (std::string_view attribute = name(); !attribute.empty(); attribute = name()) {
      const std::string_view type = name();
      const std::uint32_t size = number();
      if (size > rest_.size()) fail(fmt::format("its {} is longer than the file", attribute));
      const std::string_view behind = rest_.substr(size);
      rest_ = rest_.substr(0, size);
      if (!read_value(attribute, type))
        fail(fmt::format("its {} of the type {} cannot have {} bytes", attribute, type, size));
      if (attribute == "dataWindow") has_window = true;
      rest_ = behind;
    }
    if (!has_window) fail("it has no dataWindow");
  }

  /// Reads the value, all that is left; false where its size is not that of its type.
  bool read_value(std::string_view attribute, std::string_view type) {
    if (const auto size = size_of_type(type); size && *size != rest_.size()) return false;
    if (attribute == "dataWindow" && type != "box2i") return false;
    if (attribute == "dataWindow") read_window();
    if (attribute == "name" && type == "string" && parts_ == 1) first_name_ = rest_;
    if (type == "tiledesc") read_tile();
    if (type == "chlist") return skip_channels();
    if (type == "preview") return skip_preview();
    if (type == "stringvector") return skip_strings();
    return type != "floatvector" || rest_.size() % sizeof(float) == 0;
  }

  /// A name and 16 bytes for each channel, then an empty name.
  bool skip_channels() {
    while (!name().empty()) {
      if (rest_.size() < 16) return false;
      rest_.remove_prefix(16);
    }
    return rest_.empty();
  }

  bool skip_preview() {
    const std::uint64_t width = number(), height = number();
    return width <= rest_.size() && height <= rest_.size() && 4 * width * height == rest_.size();
  }

  /// Strings, each behind its length.
  bool skip_strings() {
    while (!rest_.empty()) {
      const std::uint32_t length = number();
      if (length > rest_.size()) return false;
      rest_.remove_prefix(length);
    }
    return true;
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
  std::size_t parts_ = 0;
  std::string first_name_;
};

}  // namespace

PictureSize check_exr_header(const PictureBytes& picture) { return HeaderReader(picture).read(); }

bool has_exr_parts(std::string_view begin) {
  const auto byte = [&](std::size_t i) { return std::uint32_t{static_cast<unsigned char>(begin[i])}; };
  return signed_format(begin) == PictureFormat::exr && begin.size() >= exr_flags_end &&
         (byte(5) << 8 & flag_parts) != 0;
}

std::string unread_exr_parts(const PictureBytes& picture) {
  HeaderReader reader(picture);
  reader.read();
  if (reader.parts() < 2) return "";
  return fmt::format("{}: it has {} parts; the first one, \"{}\", is read", picture.path, reader.parts(),
                     reader.first_name());
}

}  // namespace twinray

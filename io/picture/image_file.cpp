// SPDX-License-Identifier: Apache-2.0
#include "io/picture/image_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "core/memory.h"
#include "io/input_file.h"
#include "io/output_file.h"
#include "io/picture/exr_reader.h"
#include "io/picture/exr_writer.h"
#include "io/picture/hdr_reader.h"
#include "io/picture/image_codec.h"
#include "io/picture/jpeg_reader.h"
#include "io/picture/picture_header.h"
#include "io/picture/plain_picture.h"
#include "io/picture/png.h"
#include "io/picture/png_reader.h"
#include "io/picture/primaries.h"
#include "io/picture/srgb.h"
#include "io/picture/webp_reader.h"

namespace twinray {
namespace {

namespace fs = std::filesystem;

/// decode_srgb() of a picture's numbers, which are few: each is worked out when it first comes.
class SrgbTable {
 public:
  explicit SrgbTable(std::size_t pixels) : entries_(pixels > wide ? wide : narrow) {}

  float operator()(float encoded) {
    const float place = encoded * float(entries_.size() - 1) + 0.5f;
    if (!(place >= 0 && place < float(entries_.size()))) return decode_srgb(encoded);
    Entry& entry = entries_[std::size_t(place)];
    if (entry.encoded != encoded) entry = {encoded, decode_srgb(encoded)};
    return entry.decoded;
  }

 private:
  static constexpr std::size_t narrow = 1 << 8, wide = 1 << 16;  ///< What pictures of 8 and 16 bits have.
  struct Entry {
    float encoded = 0, decoded = 0;
  };
  std::vector<Entry> entries_;
};

void decode_all(Image& image) {
  SrgbTable decoded(image.pixels.size());
  for (Rgb& pixel : image.pixels) pixel = {decoded(pixel.r), decoded(pixel.g), decoded(pixel.b)};
}

/// The format of a file: by its first bytes, else by its ending. Throws Error where it is none that is read.
PictureFormat format_of_file(const std::string& path) {
  std::error_code error;
  std::string first(signature_bytes, '\0');
  if (fs::is_regular_file(path, error))
    std::ifstream(path, std::ios::binary).read(first.data(), std::streamsize(first.size()));
  const auto format = signed_format(first);
  return format ? *format : picture_format(path);
}

/// Throws Error where memory cannot hold so many bytes. A few are not worth the question: the answer takes
/// the system a tenth of a millisecond, as long as a small picture is read.
void check_room(const std::string& name, std::uint64_t bytes) {
  constexpr std::uint64_t few = 1 << 20;
  const MemoryNeed need{name, bytes};
  if (bytes > few) check_memory({&need, 1});
}

/// Pictures of layers have many, but not as many as a broken header says.
constexpr int most_channels = 1024;

/// Throws Error where memory cannot hold so many bytes for each pixel.
void check_pixel_room(const PictureSize& size, const PictureBytes& picture,
                      std::size_t pixel_bytes = sizeof(Rgb)) {
  check_room(fmt::format("the {} x {} pixels of {}", size.width, size.height, picture.path),
             std::uint64_t(size.width) * std::uint64_t(size.height) * pixel_bytes);
}

/// Throws Error unless the picture is of a kind that is read, and memory can hold so many bytes a pixel.
void check_kind(const PictureHeader& header, PictureFormat format, const PictureBytes& picture,
                std::size_t pixel_bytes = sizeof(Rgb)) {
  const PictureSize size{header.width, header.height};
  check_picture_size(format, size, picture);
  if (header.channels < 1 || header.channels > most_channels)
    throw Error(
        fmt::format("{}: {} channels; valid are 1 to {}", picture.path, header.channels, most_channels));
  check_pixel_room(size, picture, pixel_bytes);
}

/// PNG, JPEG, TGA and WebP are sRGB whatever their depth; the others hold linear numbers.
bool is_encoded(PictureFormat format) {
  return format == PictureFormat::png || format == PictureFormat::jpeg || format == PictureFormat::tga ||
         format == PictureFormat::webp;
}

/// Whether its size is all that must be checked.
bool is_plain(PictureFormat format) {
  return format == PictureFormat::pfm || format == PictureFormat::tga || format == PictureFormat::webp;
}

/// Throws Error where a picture has more pixels than its reader wants.
void check_pixels(const PictureSize& size, const ReadOptions& options, const std::string& path) {
  if (size.width * size.height > options.most_pixels)
    throw Error(fmt::format("{}: {} x {} pixels; valid are up to {} here", path, size.width, size.height,
                            options.most_pixels));
}

bool has_alpha(PictureFormat format) {
  return format == PictureFormat::png || format == PictureFormat::exr || format == PictureFormat::tga ||
         format == PictureFormat::webp;
}

/// The alpha as grey, of a format that may have one.
Image decode_alpha(PictureFormat format, const PictureBytes& picture, const HeaderCheck& check) {
  if (format == PictureFormat::tga) return decode_tga_alpha(picture);
  if (format == PictureFormat::webp) return decode_webp_alpha(picture);
  return (format == PictureFormat::exr ? decode_exr_alpha : decode_png_alpha)(picture, check);
}

/// The colours as they are stored.
Image decode_colors(PictureFormat format, const PictureBytes& picture, const HeaderCheck& check) {
  switch (format) {
    case PictureFormat::exr:
      return decode_exr(picture, check);
    case PictureFormat::png:
      return decode_png(picture, check);
    case PictureFormat::jpeg:
      return decode_jpeg(picture, check);
    case PictureFormat::pfm:
      return decode_pfm(picture);
    case PictureFormat::tga:
      return decode_tga(picture);
    case PictureFormat::webp:
      return decode_webp(picture);
    default:
      return decode_hdr(picture, check);
  }
}

bool is_all_one(const Image& image) {
  return std::all_of(image.pixels.begin(), image.pixels.end(), [](const Rgb& p) { return p.r == 1; });
}

/// The number that a pixel stands for; the alpha of a picture that has none.
float number_of(const Rgb& pixel, PictureChannels channels) {
  switch (channels) {
    case PictureChannels::red:
      return pixel.r;
    case PictureChannels::green:
      return pixel.g;
    case PictureChannels::blue:
      return pixel.b;
    case PictureChannels::alpha:
      return 1;
    default:
      return pixel.r == pixel.g && pixel.g == pixel.b ? pixel.r : (pixel.r + pixel.g + pixel.b) / 3;
  }
}

Image decode(PictureFormat format, const PictureBytes& picture, const ReadOptions& options) {
  const PictureSize size = check_picture_header(format, picture);
  check_pixels(size, options, picture.path);
  if (is_plain(format)) check_pixel_room(size, picture);
  const auto check = [&](const PictureHeader& header) { check_kind(header, format, picture); };
  const bool is_number = options.channels == PictureChannels::number;
  if ((is_number || options.channels == PictureChannels::alpha) && has_alpha(format)) {
    Image alpha = decode_alpha(format, picture, check);
    if (!is_number || !is_all_one(alpha)) return alpha;
  }
  Image image = decode_colors(format, picture, check);
  if (is_encoded(format) && options.role == PictureRole::color) decode_all(image);
  if (format == PictureFormat::exr && options.role == PictureRole::color)
    if (const auto primaries = decode_exr_primaries(picture, check)) take_as_srgb(*primaries, image);
  if (options.channels != PictureChannels::color)
    for (Rgb& pixel : image.pixels) {
      const float number = number_of(pixel, options.channels);
      pixel = {number, number, number};
    }
  return image;
}

bool is_whole(const Image& image, const ImageFrame& frame) {
  return frame.x == 0 && frame.y == 0 && frame.width == image.width && frame.height == image.height;
}

/// A picture in its frame: black around, and without what lies outside.
Image framed(const Image& image, const ImageFrame& frame) {
  Image whole(frame.width, frame.height);
  const auto end = [](int begin, int size, int most) {
    return int(std::min(std::int64_t(begin) + size, std::int64_t(most)));
  };
  for (int y = std::max(0, frame.y); y < end(frame.y, image.height, frame.height); ++y)
    for (int x = std::max(0, frame.x); x < end(frame.x, image.width, frame.width); ++x)
      whole.at(x, y) = image.at(x - frame.x, y - frame.y);
  return whole;
}

std::string read_bytes(const std::string& path) {
  check_regular_file(path, "picture");
  std::error_code error;
  const std::uint64_t size = fs::file_size(path, error);
  if (!error) check_room(path, size);
  std::string bytes(error ? 0 : std::size_t(size), '\0');
  std::ifstream file(path, std::ios::binary);
  if (error || !file.read(bytes.data(), std::streamsize(bytes.size())))
    throw Error(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
  return bytes;
}

void write_bytes(const std::string& path, const std::vector<unsigned char>& bytes) {
  write_file(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace

void write_png(const std::string& path, const ByteImage& image, const ImageMetadata& metadata) {
  write_bytes(path, encode_png(image, metadata));
}

void write_exr(const std::string& path, const LayeredImage& image, const ImageMetadata& metadata,
               const ImageFrame& frame) {
  write_bytes(path, encode_exr(image, metadata, frame));
}

void write_exr(const std::string& path, const Image& image, const ImageMetadata& metadata,
               const ImageFrame& frame) {
  const auto fill_row = [&image](int y, std::span<float> values) {
    for (std::size_t i = 0; i < values.size(); i += 3) {
      const Rgb& pixel = image.at(int(i / 3), y);
      values[i] = pixel.r;
      values[i + 1] = pixel.g;
      values[i + 2] = pixel.b;
    }
  };
  write_exr(path, LayeredImage{image.width, image.height, {{"R"}, {"G"}, {"B"}}, fill_row}, metadata, frame);
}

void write_linear(const std::string& path, const Image& image, const ImageMetadata& metadata,
                  const ImageFrame& frame) {
  const OutputFormat format = output_format(path);
  if (format == OutputFormat::exr) return write_exr(path, image, metadata, frame);
  if (format == OutputFormat::pfm) return write_file(path, encode_pfm(image));
  write_bytes(path, image_codec().encode_floats(format, path, image, metadata));
}

void write_display(const std::string& path, const ByteImage& image, const ImageMetadata& metadata) {
  if (output_format(path) == OutputFormat::jpeg)
    write_bytes(path, image_codec().encode_jpeg(path, image, metadata));
  else
    write_png(path, image, metadata);
}

void write_image(const std::string& path, const Image& image, const ImageMetadata& metadata,
                 const ImageFrame& frame) {
  if (is_linear(output_format(path)))
    write_linear(path, image, metadata, frame);
  else
    write_display(path, encode_srgb(image), metadata);
}

bool holds_radiance(const std::string& path) { return !is_encoded(picture_format(path)); }

Image read_image(const std::string& path, const ReadOptions& options) {
  const PictureFormat format = format_of_file(path);
  const std::string bytes = read_bytes(path);
  return decode(format, {bytes, path}, options);
}

Image read_framed_image(const std::string& path) {
  const PictureFormat format = format_of_file(path);
  const std::string bytes = read_bytes(path);
  const PictureBytes picture{bytes, path};
  Image image = decode(format, picture, {});
  if (format != PictureFormat::exr) return image;
  const ImageFrame frame =
      decode_exr_frame(picture, [&](const PictureHeader& header) { check_kind(header, format, picture); });
  if (is_whole(image, frame)) return image;
  const PictureSize size{frame.width, frame.height};
  check_picture_size(format, size, picture);
  check_pixel_room(size, picture);
  return framed(image, frame);
}

StoredLayers read_layers(const std::string& path) {
  if (format_of_file(path) != PictureFormat::exr)
    throw Error(path + ": it holds no layers; an OpenEXR picture, .exr, may");
  const std::string bytes = read_bytes(path);
  const PictureBytes picture{bytes, path};
  check_picture_header(PictureFormat::exr, picture);
  return decode_exr_layers(picture, [&](const PictureHeader& header) {
    check_kind(header, PictureFormat::exr, picture, std::size_t(header.channels) * sizeof(float));
  });
}

/// Files of one part, which most are, are not read a second time for this.
std::string unread_parts(const std::string& path) {
  std::array<char, exr_flags_end> begin{};
  std::ifstream(path, std::ios::binary).read(begin.data(), begin.size());
  return has_exr_parts({begin.data(), begin.size()}) ? unread_parts(read_bytes(path), path) : "";
}

std::string unread_parts(std::string_view bytes, const std::string& name) {
  return signed_format(bytes) == PictureFormat::exr ? unread_exr_parts({bytes, name}) : "";
}

ImageMetadata read_metadata(const std::string& path) {
  const PictureFormat format = format_of_file(path);
  if (is_plain(format)) return {};
  const std::string bytes = read_bytes(path);
  const PictureBytes picture{bytes, path};
  check_picture_header(format, picture);
  const auto check = [&](const PictureHeader& header) { check_kind(header, format, picture); };
  if (format == PictureFormat::exr) return decode_exr_metadata(picture, check);
  if (format == PictureFormat::png) return decode_png_metadata(picture, check);
  return image_codec().read_metadata(format, picture, check);
}

std::optional<ImageFrame> read_frame(const std::string& path) {
  if (format_of_file(path) != PictureFormat::exr)
    return frame_of_value(value_of(read_metadata(path), frame_key));
  const std::string bytes = read_bytes(path);
  const PictureBytes picture{bytes, path};
  check_picture_header(PictureFormat::exr, picture);
  return decode_exr_frame(
      picture, [&](const PictureHeader& header) { check_kind(header, PictureFormat::exr, picture); });
}

std::vector<float> read_channel(const std::string& path, const std::string& name) {
  if (format_of_file(path) != PictureFormat::exr) return {};
  const std::string bytes = read_bytes(path);
  const PictureBytes picture{bytes, path};
  check_picture_header(PictureFormat::exr, picture);
  return decode_exr_channel(
      picture, name, [&](const PictureHeader& header) { check_kind(header, PictureFormat::exr, picture); });
}

Image decode_image(std::string_view bytes, const std::string& name, const ReadOptions& options) {
  auto format = signed_format(bytes);
  if (!format) format = known_picture_format(name);
  if (!format)
    throw Error(name +
                ": its first bytes are of no picture that is read; valid are PNG, JPEG, WebP, OpenEXR");
  return decode(*format, {bytes, name}, options);
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "io/image_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>

#include "core/elementary.h"
#include "core/error.h"
#include "core/memory.h"
#include "io/destination.h"
#include "io/exr_header.h"
#include "io/image_codec.h"
#include "io/output_file.h"
#include "io/png.h"

namespace twinray {
namespace {

namespace fs = std::filesystem;

std::string extension_of(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

/// The reader of a file by its ending: never by its contents, so that only well-tried readers see a
/// stranger's file.
const char* reader_for(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension == ".exr") return "openexr";
  if (extension == ".hdr") return "hdr";
  if (extension == ".png") return "png";
  if (extension == ".jpg" || extension == ".jpeg") return "jpeg";
  throw Error(
      fmt::format("{}: not a picture that can be read; valid endings are .exr, .hdr, .png, .jpg", path));
}

float decode_srgb(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : float(pow_of((double(encoded) + 0.055) / 1.055, 2.4));
}

void decode_srgb(Image& image) {
  for (Rgb& pixel : image.pixels) pixel = {decode_srgb(pixel.r), decode_srgb(pixel.g), decode_srgb(pixel.b)};
}

/// Throws Error unless the header is that of a picture that the file may hold: before any memory is taken.
void check_header(const ImageCodec::Header& header, const std::string& path, std::string_view reader) {
  check_picture_size(path, header.width, header.height,
                     reader == "png"    ? pixels_a_png_byte
                     : reader == "jpeg" ? pixels_a_jpeg_byte
                                        : pixels_a_byte);
  if (header.channels < 1 || header.channels > 64)
    throw Error(fmt::format("{}: {} channels; valid are 1 to 64", path, header.channels));
  if (header.is_deep)
    throw Error(fmt::format("{}: a deep picture, or one of several layers in depth, is not read", path));
  const std::uint64_t pixels = std::uint64_t(header.width) * std::uint64_t(header.height);
  const MemoryNeed need{fmt::format("the {} x {} pixels of {}", header.width, header.height, path),
                        pixels * sizeof(Rgb)};
  check_memory({&need, 1});
}

void write_bytes(const std::string& path, const std::vector<unsigned char>& bytes) {
  write_file(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

/// PNG and JPEG are sRGB whatever their depth; the others hold linear numbers.
bool is_encoded(const char* reader) {
  const std::string_view name = reader;
  return name == "png" || name == "jpeg";
}

}  // namespace

void check_image_name(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension == ".png" || extension == ".exr") return;
  if (destination_of(path).kind == Destination::Kind::file)
    throw Error(fmt::format("{}: a picture's name must end in .png or .exr", path));
}

void write_png(const std::string& path, const ByteImage& image, const ImageMetadata& metadata) {
  write_bytes(path, encode_png(image, metadata));
}

bool is_linear_output(const std::string& path) { return extension_of(path) == ".exr"; }

void write_exr(const std::string& path, const Image& image, const ImageMetadata& metadata,
               const ImageFrame& frame) {
  write_bytes(path, image_codec().encode_exr(path, image, metadata, frame));
}

void write_image(const std::string& path, const Image& image, const ImageMetadata& metadata,
                 const ImageFrame& frame) {
  if (is_linear_output(path))
    write_exr(path, image, metadata, frame);
  else
    write_png(path, encode_srgb(image), metadata);
}

Image read_image(const std::string& path) {
  const char* reader = reader_for(path);
  if (!fs::is_regular_file(path)) throw Error(fmt::format("{}: there is no such file", path));
  if (reader == std::string_view("openexr")) check_exr_header(path);
  Image image = image_codec().read(
      path, reader, [&](const ImageCodec::Header& header) { check_header(header, path, reader); });
  if (is_encoded(reader)) decode_srgb(image);
  return image;
}

}  // namespace twinray

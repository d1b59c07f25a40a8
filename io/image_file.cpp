// SPDX-License-Identifier: Apache-2.0
#include "io/image_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <string_view>

#include "core/elementary.h"
#include "core/error.h"
#include "core/memory.h"
#include "io/destination.h"
#include "io/exr_header.h"
#include "io/output_file.h"

namespace twinray {
namespace {

namespace fs = std::filesystem;

std::string extension_of(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

/// OpenEXR would make as many threads as the machine has for every file, and fail where it gets none.
void use_no_threads() { OIIO::attribute("exr_threads", -1); }

/// The bytes of a picture's file. It is put together in memory, since OpenImageIO does not notice a full disk
/// when it writes a PNG, and a pipe cannot be written in any other order.
std::vector<unsigned char> encoded(const std::string& path, const char* format, const OIIO::ImageSpec& spec,
                                   const void* pixels) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  use_no_threads();
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
  if (!output || !output->set_ioproxy(&memory))
    throw Error(fmt::format("{}: OpenImageIO cannot write {}: {}", path, format, OIIO::geterror()));
  if (!output->open(path, spec) || !output->write_image(spec.format, pixels) || !output->close())
    throw Error(fmt::format("{}: cannot be written: {}", path, output->geterror()));
  return bytes;
}

void write(const std::string& path, const char* format, OIIO::ImageSpec spec, const void* pixels,
           const ImageMetadata& metadata) {
  spec.attribute("DateTime", "");  // Without any, OpenImageIO would take the time of now.
  for (const auto& [name, value] : metadata) spec.attribute(name, value);
  const std::vector<unsigned char> bytes = encoded(path, format, spec, pixels);
  write_file(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
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

/// The first three channels of all pixels, or the first one as grey.
Image read_colors(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, const std::string& path) {
  Image image(spec.width, spec.height);
  const int channels = spec.nchannels >= 3 ? 3 : 1;
  const auto pixel_bytes = OIIO::stride_t(sizeof(Rgb));
  if (!input.read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, image.pixels.data(), pixel_bytes))
    throw Error(fmt::format("{}: cannot be read: {}", path, input.geterror()));
  if (channels == 1)
    for (Rgb& pixel : image.pixels) pixel = {pixel.r, pixel.r, pixel.r};
  return image;
}

void decode_srgb(Image& image) {
  for (Rgb& pixel : image.pixels) pixel = {decode_srgb(pixel.r), decode_srgb(pixel.g), decode_srgb(pixel.b)};
}

/// Throws Error unless the header is that of a picture that the file may hold: before any memory is taken.
void check_header(const OIIO::ImageSpec& spec, const std::string& path, std::string_view reader) {
  check_picture_size(path, spec.width, spec.height,
                     reader == "png"    ? pixels_a_png_byte
                     : reader == "jpeg" ? pixels_a_jpeg_byte
                                        : pixels_a_byte);
  if (spec.nchannels < 1 || spec.nchannels > 64)
    throw Error(fmt::format("{}: {} channels; valid are 1 to 64", path, spec.nchannels));
  if (spec.depth > 1 || spec.deep)
    throw Error(fmt::format("{}: a deep picture, or one of several layers in depth, is not read", path));
  const std::uint64_t pixels = std::uint64_t(spec.width) * std::uint64_t(spec.height);
  const MemoryNeed need{fmt::format("the {} x {} pixels of {}", spec.width, spec.height, path),
                        pixels * sizeof(Rgb)};
  check_memory({&need, 1});
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
  const OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::UINT8);
  write(path, "png", spec, image.bytes.data(), metadata);
}

bool is_linear_output(const std::string& path) { return extension_of(path) == ".exr"; }

void write_exr(const std::string& path, const Image& image, const ImageMetadata& metadata,
               const ImageFrame& frame) {
  static_assert(sizeof(Rgb) == 3 * sizeof(float));
  OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::FLOAT);
  spec.x = frame.x;
  spec.y = frame.y;
  spec.full_width = frame.width > 0 ? frame.width : image.width;
  spec.full_height = frame.height > 0 ? frame.height : image.height;
  write(path, "openexr", spec, image.pixels.data(), metadata);
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
  use_no_threads();
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(reader);
  if (!fs::is_regular_file(path)) throw Error(fmt::format("{}: there is no such file", path));
  if (reader == std::string_view("openexr")) check_exr_header(path);
  OIIO::ImageSpec spec;
  if (!input || !input->open(path, spec))
    throw Error(fmt::format("{}: cannot be read: {}", path, input ? input->geterror() : OIIO::geterror()));
  check_header(spec, path, reader);
  Image image = read_colors(*input, spec, path);
  if (is_encoded(reader)) decode_srgb(image);
  return image;
}

}  // namespace twinray

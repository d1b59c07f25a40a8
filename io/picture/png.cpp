// SPDX-License-Identifier: Apache-2.0
#include "io/picture/png.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cstdio>
#include <new>
#include <string>

#include "core/error.h"

namespace twinray {
namespace {

/// libpng reports by a function that must not return, and is compiled so that exceptions pass through it.
[[noreturn]] void fail(png_structp, png_const_charp reason) {
  throw Error(fmt::format("a PNG cannot be made: {}", reason));
}

void ignore(png_structp, png_const_charp) {}

void append(png_structp png, png_bytep bytes, std::size_t size) {
  auto& file = *static_cast<std::vector<unsigned char>*>(png_get_io_ptr(png));
  file.insert(file.end(), bytes, bytes + size);
}

bool is_ascii(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](unsigned char c) { return c < 128; });
}

/// libpng's state of one file that is being written.
class Writer {
 public:
  explicit Writer(std::vector<unsigned char>& file)
      : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore)),
        info_(png_ ? png_create_info_struct(png_) : nullptr) {
    if (!info_) throw std::bad_alloc();
    png_set_write_fn(png_, &file, append, nullptr);
  }
  ~Writer() { png_destroy_write_struct(&png_, &info_); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  void set_size(int width, int height, int color_type = PNG_COLOR_TYPE_RGB) {
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_IHDR(png_, info_, png_uint_32(width), png_uint_32(height), 8, color_type, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(png_, info_, PNG_sRGB_INTENT_PERCEPTUAL);
  }

  /// "2023:11:14 22:13:20"; anything else is left out.
  void set_time(const std::string& text) {
    int year = 0, month = 0, day = 0, hour = 0, minute = 0, second = 0;
    if (std::sscanf(text.c_str(), "%d:%d:%d %d:%d:%d", &year, &month, &day, &hour, &minute, &second) != 6)
      return;
    const png_time time{png_uint_16(year), png_byte(month),  png_byte(day),
                        png_byte(hour),    png_byte(minute), png_byte(second)};
    png_set_tIME(png_, info_, &time);
  }

  /// libpng keeps a copy, and changes nothing in what it is given.
  void set_text(const std::string& name, const std::string& value) {
    png_text text{};
    text.compression = is_ascii(value) ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    text.key = const_cast<char*>(name.c_str());
    text.text = const_cast<char*>(value.c_str());
    png_set_text(png_, info_, &text, 1);
  }

  /// `channels`: how many bytes a pixel has.
  template <typename Picture>
  void write(const Picture& image, std::size_t channels) {
    png_write_info(png_, info_);
    const std::size_t row_bytes = channels * std::size_t(image.width);
    for (std::size_t row = 0; row < std::size_t(image.height); ++row)
      png_write_row(png_, image.bytes.data() + row * row_bytes);
    png_write_end(png_, info_);
  }

 private:
  png_structp png_;
  png_infop info_;
};

}  // namespace

std::vector<unsigned char> encode_png(const ByteImage& image, const ImageMetadata& metadata) {
  std::vector<unsigned char> file;
  Writer writer(file);
  writer.set_size(image.width, image.height);
  for (const auto& [name, value] : metadata)
    if (name == "DateTime")
      writer.set_time(value);
    else
      writer.set_text(name, value);
  writer.write(image, 3);
  return file;
}

std::vector<unsigned char> encode_png(const AlphaImage& image) {
  std::vector<unsigned char> file;
  Writer writer(file);
  writer.set_size(image.width, image.height, PNG_COLOR_TYPE_RGB_ALPHA);
  writer.write(image, 4);
  return file;
}

}  // namespace twinray

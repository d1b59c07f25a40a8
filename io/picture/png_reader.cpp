// SPDX-License-Identifier: Apache-2.0
#include "io/picture/png_reader.h"

#include <fmt/format.h>
#include <png.h>

#include <new>
#include <span>
#include <string_view>
#include <vector>

namespace twinray {
namespace {

/// As in png.cpp: exceptions pass through libpng.
[[noreturn]] void fail_reading(png_structp png, png_const_charp reason) {
  fail_picture(*static_cast<const PictureBytes*>(png_get_error_ptr(png)), reason);
}

void ignore_warning(png_structp, png_const_charp) {}

/// Takes the next bytes of the rest of the file.
void take(png_structp png, png_bytep to, std::size_t count) {
  auto& rest = *static_cast<std::string_view*>(png_get_io_ptr(png));
  if (count > rest.size()) png_error(png, "it is cut off");
  rest.copy(reinterpret_cast<char*>(to), count);
  rest.remove_prefix(count);
}

/// What is packed beside the pixels, texts and profiles, may be a thousand times as large as the file: of so
/// many chunks, each of so many bytes at most, there is enough for all that pictures say. Others are left
/// out.
constexpr int most_texts = 100;
constexpr std::size_t longest_text = 1 << 18;

/// libpng's state of one file that is being read.
struct PngState {
  png_structp png;
  png_infop info;

  explicit PngState(const PictureBytes& picture)
      : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, const_cast<PictureBytes*>(&picture), fail_reading,
                                   ignore_warning)),
        info(png ? png_create_info_struct(png) : nullptr) {
    if (!info) throw std::bad_alloc();
  }
  ~PngState() { png_destroy_read_struct(&png, &info, nullptr); }
  PngState(const PngState&) = delete;
  PngState& operator=(const PngState&) = delete;
};

/// A picture whose header is read: of grey or colours, each with alpha or without, and of 8 or 16 bits.
class PngFile {
 public:
  /// `check` sees the header.
  PngFile(const PictureBytes& picture, const HeaderCheck& check) : state_(picture), rest_(picture.bytes) {
    png_set_chunk_cache_max(png(), most_texts);
    png_set_chunk_malloc_max(png(), longest_text);
    png_set_user_limits(png(), PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_read_fn(png(), &rest_, take);
    png_read_info(png(), info());
    png_set_expand(png());  // Palettes to colours, what is transparent to an alpha, fewer bits to 8.
    passes_ = png_set_interlace_handling(png());
    png_read_update_info(png(), info());
    check({width(), height(), int(channels())});
  }

  int width() const { return int(png_get_image_width(png(), info())); }
  int height() const { return int(png_get_image_height(png(), info())); }
  std::size_t channels() const { return png_get_channels(png(), info()); }
  bool has_alpha() const { return channels() % 2 == 0; }

  /// All pixels, each made of its channels by a function.
  template <typename Make>
  Image read(const Make& make) {
    const bool is_wide = png_get_bit_depth(png(), info()) == 16;
    const std::size_t row_bytes = png_get_rowbytes(png(), info());
    // A picture that becomes finer by and by is there as a whole at its end.
    std::vector<png_byte> rows(row_bytes * (passes_ > 1 ? std::size_t(height()) : 1));
    const auto row = [&](int y) { return rows.data() + (passes_ > 1 ? row_bytes * std::size_t(y) : 0); };
    for (int pass = 0; pass + 1 < passes_; ++pass)
      for (int y = 0; y < height(); ++y) png_read_row(png(), row(y), nullptr);
    Image image(width(), height());
    std::vector<float> values(channels());
    for (int y = 0; y < height(); ++y) {
      png_read_row(png(), row(y), nullptr);
      const png_byte* at = row(y);
      for (int x = 0; x < width(); ++x) {
        for (float& value : values) {  // Scaled as OpenImageIO does it, so that textures have the same bits.
          value = is_wide ? float(256 * at[0] + at[1]) * (1.0f / 65535) : float(at[0]) * (1.0f / 255);
          at += is_wide ? 2 : 1;
        }
        image.at(x, y) = make(values);
      }
    }
    return image;
  }

  ImageMetadata texts() const {
    ImageMetadata texts;
    png_textp list = nullptr;
    const int count = png_get_text(png(), info(), &list, nullptr);
    for (const png_text& text : std::span(list, std::size_t(count))) texts.emplace_back(text.key, text.text);
    png_timep time = nullptr;
    if (png_get_tIME(png(), info(), &time))
      texts.emplace_back(
          "DateTime", fmt::format("{:04}:{:02}:{:02} {:02}:{:02}:{:02}", time->year, time->month, time->day,
                                  time->hour, time->minute, time->second));
    return texts;
  }

 private:
  png_structp png() const { return state_.png; }
  png_infop info() const { return state_.info; }

  PngState state_;
  std::string_view rest_;
  int passes_ = 1;
};

}  // namespace

Image decode_png(const PictureBytes& picture, const HeaderCheck& check) {
  PngFile file(picture, check);
  if (file.channels() < 3)
    return file.read([](const std::vector<float>& grey) { return Rgb{grey[0], grey[0], grey[0]}; });
  return file.read([](const std::vector<float>& color) { return Rgb{color[0], color[1], color[2]}; });
}

Image decode_png_alpha(const PictureBytes& picture, const HeaderCheck& check) {
  PngFile file(picture, check);
  if (!file.has_alpha()) return Image(file.width(), file.height(), white);
  return file.read([](const std::vector<float>& values) {
    return Rgb{values.back(), values.back(), values.back()};
  });
}

ImageMetadata decode_png_metadata(const PictureBytes& picture, const HeaderCheck& check) {
  return PngFile(picture, check).texts();
}

}  // namespace twinray

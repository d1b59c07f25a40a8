// SPDX-License-Identifier: Apache-2.0
// PNG pictures of every kind, made by PNG's own library: whatever their bits, channels and order of rows, the
// same numbers come out.
#include "io/picture/png_reader.h"

#include <png.h>

#include <string>
#include <vector>

#include "io/picture/image_file.h"
#include "io/picture/png.h"
#include "io/picture/srgb.h"
#include "tests/support/catch.h"

namespace twinray::test {
namespace {

struct PngKind {
  int color_type, channels, bits;
  bool is_interlaced;
};

constexpr int png_width = 11, png_height = 9;

/// What a channel of a pixel holds, of all numbers that it can.
int stored_value(const PngKind& kind, int x, int y, int channel) {
  return (x * 7919 + y * 104729 + channel * 1299709) & ((1 << kind.bits) - 1);
}

/// Rows of one byte a value, or two.
std::vector<png_bytep> make_rows(const PngKind& kind, std::vector<std::vector<png_byte>>& rows) {
  std::vector<png_bytep> places;
  for (int y = 0; y < png_height; ++y) {
    std::vector<png_byte>& row = rows.emplace_back();
    for (int x = 0; x < png_width; ++x)
      for (int channel = 0; channel < kind.channels; ++channel) {
        const int value = stored_value(kind, x, y, channel);
        if (kind.bits == 16) row.push_back(png_byte(value >> 8));
        row.push_back(png_byte(value & 255));
      }
  }
  for (std::vector<png_byte>& row : rows) places.push_back(row.data());
  return places;
}

/// The file of a kind; what a palette holds, which of it is transparent, and texts may be given.
std::string png_file(const PngKind& kind, const std::vector<png_color>& palette = {},
                     std::vector<png_byte> alphas = {}, const std::vector<png_text>& texts = {}) {
  std::string file;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &file,
      [](png_structp state, png_bytep bytes, std::size_t count) {
        static_cast<std::string*>(png_get_io_ptr(state))->append(reinterpret_cast<char*>(bytes), count);
      },
      nullptr);
  png_set_IHDR(png, info, png_width, png_height, kind.bits, kind.color_type,
               kind.is_interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  if (!palette.empty()) png_set_PLTE(png, info, palette.data(), int(palette.size()));
  if (!alphas.empty()) png_set_tRNS(png, info, alphas.data(), int(alphas.size()), nullptr);
  if (!texts.empty()) png_set_text(png, info, texts.data(), int(texts.size()));
  png_write_info(png, info);
  png_set_packing(png);
  std::vector<std::vector<png_byte>> rows;
  std::vector<png_bytep> places = make_rows(kind, rows);
  png_write_image(png, places.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return file;
}

/// Refuses nothing, and notes what it sees.
HeaderCheck noting(PictureHeader& seen) {
  return [&seen](const PictureHeader& header) { seen = header; };
}

void check_kind(const PngKind& kind) {
  CAPTURE(kind.color_type, kind.bits, kind.is_interlaced);
  const std::string bytes = png_file(kind), name = "a.png";
  PictureHeader header;
  const Image image = decode_png({bytes, name}, noting(header));
  const Image alpha = decode_png_alpha({bytes, name}, noting(header));
  CHECK((header.width == png_width && header.height == png_height && header.channels == kind.channels));
  const int most = (1 << kind.bits) - 1, whole = kind.bits == 16 ? 65535 : 255;
  const bool has_alpha = kind.channels % 2 == 0;
  for (int y = 0; y < png_height; ++y)
    for (int x = 0; x < png_width; ++x) {
      const auto value = [&](int channel) {
        return float(stored_value(kind, x, y, channel) * (whole / most)) * (1.0f / float(whole));
      };
      const bool is_grey = kind.channels < 3;
      CHECK(image.at(x, y) == Rgb{value(0), value(is_grey ? 0 : 1), value(is_grey ? 0 : 2)});
      const float a = has_alpha ? value(kind.channels - 1) : 1;
      CHECK(alpha.at(x, y) == Rgb{a, a, a});
    }
}

}  // namespace

TEST_CASE("PNGs of all bits and channels, in one pass or several, give the numbers that they store") {
  for (const bool is_interlaced : {false, true}) {
    for (const int bits : {1, 2, 4, 8, 16}) check_kind({PNG_COLOR_TYPE_GRAY, 1, bits, is_interlaced});
    for (const int bits : {8, 16}) {
      check_kind({PNG_COLOR_TYPE_GRAY_ALPHA, 2, bits, is_interlaced});
      check_kind({PNG_COLOR_TYPE_RGB, 3, bits, is_interlaced});
      check_kind({PNG_COLOR_TYPE_RGB_ALPHA, 4, bits, is_interlaced});
    }
  }
}

TEST_CASE("colours of 16 bits are decoded as each number alone") {
  const PngKind kind{PNG_COLOR_TYPE_RGB, 3, 16, false};
  const Image image = decode_image(png_file(kind), "a.png");
  for (int y = 0; y < png_height; ++y)
    for (int x = 0; x < png_width; ++x)
      CHECK(image.at(x, y).g == decode_srgb(float(stored_value(kind, x, y, 1)) * (1.0f / 65535)));
}

TEST_CASE("a palette's colours and what is transparent of them are read") {
  const PngKind kind{PNG_COLOR_TYPE_PALETTE, 1, 2, false};
  const std::vector<png_color> palette{{255, 0, 51}, {0, 102, 0}, {153, 204, 255}, {51, 51, 51}};
  const std::string bytes = png_file(kind, palette, {255, 51}), name = "a.png";
  PictureHeader header;
  const Image image = decode_png({bytes, name}, noting(header));
  const Image alpha = decode_png_alpha({bytes, name}, noting(header));
  CHECK(header.channels == 4);
  for (int y = 0; y < png_height; ++y)
    for (int x = 0; x < png_width; ++x) {
      const int index = stored_value(kind, x, y, 0);
      const png_color& color = palette[std::size_t(index)];
      const auto of_byte = [](png_byte byte) { return float(byte) * (1.0f / 255); };
      CHECK(image.at(x, y) == Rgb{of_byte(color.red), of_byte(color.green), of_byte(color.blue)});
      CHECK(alpha.at(x, y).r == of_byte(index == 1 ? 51 : 255));
    }
}

TEST_CASE("a PNG that is cut off within its pixels is refused by its name") {
  const std::string bytes = png_file({PNG_COLOR_TYPE_RGB, 3, 8, false}), name = "a.png";
  const std::size_t pixels = bytes.find("IDAT"), end = bytes.find("IEND");
  REQUIRE((pixels != bytes.npos && end != bytes.npos));
  PictureHeader header;
  for (std::size_t length = 24; length < (pixels + end) / 2; ++length) {
    const std::string_view part = std::string_view(bytes).substr(0, length);
    CHECK_THROWS_WITH(decode_png({part, name}, noting(header)), "a.png: cannot be read: it is cut off");
  }
}

TEST_CASE("a PNG is refused before memory is taken for its pixels") {
  const std::string bytes = png_file({PNG_COLOR_TYPE_RGB, 3, 8, false}), name = "a.png";
  const HeaderCheck refuse = [](const PictureHeader&) { throw Error("too large"); };
  CHECK_THROWS_WITH(decode_png({bytes, name}, refuse), "too large");
  CHECK_THROWS_WITH(decode_png_metadata({bytes, name}, refuse), "too large");
}

TEST_CASE("a PNG's texts and time are read as they were written") {
  const ImageMetadata written{
      {"Software", "ours"}, {"DateTime", "2023:11:14 22:13:20"}, {"other", "Größe 箱"}};
  const std::vector<unsigned char> file = encode_png({1, 1, {1, 2, 3}}, written);
  const std::string bytes(file.begin(), file.end()), name = "a.png";
  PictureHeader header;
  const ImageMetadata read = decode_png_metadata({bytes, name}, noting(header));
  CHECK(read.size() == 3);
  for (const auto& [key, value] : written) CHECK(value_of(read, key) == value);
}

TEST_CASE("packed texts of a PNG are read to a length and a number that pictures have") {
  const auto texts = [](std::size_t count, std::size_t length) {
    const std::string text(length, 'x');
    std::vector<png_text> packed(count);
    for (png_text& each : packed) {
      each.compression = PNG_TEXT_COMPRESSION_zTXt;
      each.key = const_cast<char*>("key");
      each.text = const_cast<char*>(text.c_str());
      each.text_length = length;
    }
    const std::string bytes = png_file({PNG_COLOR_TYPE_GRAY, 1, 8, false}, {}, {}, packed), name = "a.png";
    CHECK(bytes.size() < 100'000);
    PictureHeader header;
    CHECK(decode_png({bytes, name}, noting(header)).width == png_width);
    return decode_png_metadata({bytes, name}, noting(header));
  };
  CHECK(texts(1, 200'000).size() == 1);
  CHECK(texts(1, 300'000).empty());
  const std::size_t several = texts(150, 10).size();
  CHECK((several >= 90 && several <= 110));
}

}  // namespace twinray::test

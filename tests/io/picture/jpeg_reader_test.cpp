// SPDX-License-Identifier: Apache-2.0
// JPEG pictures of every kind, made by libjpeg: their colours come out, and what is missing is told.
#include "io/picture/jpeg_reader.h"

#include <cmath>
#include <cstdio>  // Before jpeglib.h, which does without it.
#include <cstdlib>
#include <string>
#include <vector>

#include <jpeglib.h>

#include "tests/support/catch.h"

namespace twinray::test {
namespace {

constexpr int jpeg_width = 40, jpeg_height = 24;

struct JpegKind {
  J_COLOR_SPACE given, stored;
  int channels;
  bool is_progressive = false;
};
constexpr JpegKind colored{JCS_RGB, JCS_YCbCr, 3}, grey{JCS_GRAYSCALE, JCS_GRAYSCALE, 1};

/// What a channel of a pixel holds: it changes slowly, as JPEG likes it.
int stored_value(int x, int y, int channel) { return 40 + 2 * x + y * channel + 15 * channel; }

std::string jpeg_file(const JpegKind& kind) {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &bytes, &size);
  jpeg.image_width = jpeg_width;
  jpeg.image_height = jpeg_height;
  jpeg.input_components = kind.channels;
  jpeg.in_color_space = kind.given;
  jpeg_set_defaults(&jpeg);
  jpeg_set_colorspace(&jpeg, kind.stored);
  jpeg_set_quality(&jpeg, 100, TRUE);
  for (int c = 0; c < kind.channels; ++c)
    jpeg.comp_info[c].h_samp_factor = jpeg.comp_info[c].v_samp_factor = 1;
  if (kind.is_progressive) jpeg_simple_progression(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  std::vector<JSAMPLE> row;
  for (int y = 0; y < jpeg_height; ++y) {
    row.clear();
    for (int x = 0; x < jpeg_width; ++x)
      for (int c = 0; c < kind.channels; ++c) row.push_back(JSAMPLE(stored_value(x, y, c)));
    JSAMPROW rows[]{row.data()};
    jpeg_write_scanlines(&jpeg, rows, 1);
  }
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  std::string file(reinterpret_cast<const char*>(bytes), size);
  std::free(bytes);
  return file;
}

/// Refuses nothing.
void accept_all(const PictureHeader&) {}

Image decoded(const std::string& bytes) { return decode_jpeg({bytes, "a.jpg"}, accept_all); }

}  // namespace

TEST_CASE("a JPEG has the colours, or the grey, that it was made of") {
  for (const JpegKind& kind : {colored, JpegKind{JCS_RGB, JCS_RGB, 3}, JpegKind{JCS_RGB, JCS_YCbCr, 3, true},
                               grey, JpegKind{JCS_GRAYSCALE, JCS_GRAYSCALE, 1, true}}) {
    CAPTURE(kind.given, kind.stored, kind.is_progressive);
    const std::string bytes = jpeg_file(kind), name = "a.jpg";
    PictureHeader header;
    const Image image = decode_jpeg({bytes, name}, [&](const PictureHeader& seen) { header = seen; });
    REQUIRE((image.width == jpeg_width && image.height == jpeg_height));
    CHECK((header.width == jpeg_width && header.height == jpeg_height && header.channels == kind.channels));
    for (int y = 0; y < jpeg_height; ++y)
      for (int x = 0; x < jpeg_width; ++x)
        for (int c = 0; c < 3; ++c) {
          const Rgb& pixel = image.at(x, y);
          const float value = c == 0 ? pixel.r : c == 1 ? pixel.g : pixel.b;
          const int stored = stored_value(x, y, kind.channels == 1 ? 0 : c);
          REQUIRE(std::fabs(255 * value - float(stored)) < 3);
          REQUIRE(value * 255 == Approx(std::round(value * 255)).margin(1e-4));
        }
  }
}

TEST_CASE("a printer's colours are multiplied by its black") {
  for (const J_COLOR_SPACE stored : {JCS_CMYK, JCS_YCCK}) {
    const Image image = decoded(jpeg_file({JCS_CMYK, stored, 4}));
    for (int y = 0; y < jpeg_height; ++y)
      for (int x = 0; x < jpeg_width; ++x) {
        const float black = float(stored_value(x, y, 3)) / 255;
        const float expected[]{float(stored_value(x, y, 0)) * black, float(stored_value(x, y, 1)) * black,
                               float(stored_value(x, y, 2)) * black};
        REQUIRE(std::fabs(255 * image.at(x, y).r - expected[0]) < 5);
        REQUIRE(std::fabs(255 * image.at(x, y).g - expected[1]) < 5);
        REQUIRE(std::fabs(255 * image.at(x, y).b - expected[2]) < 5);
      }
  }
}

TEST_CASE("a JPEG that is cut off or damaged is an error, wherever it is") {
  for (const JpegKind& kind : {colored, grey, JpegKind{JCS_RGB, JCS_YCbCr, 3, true}}) {
    const std::string bytes = jpeg_file(kind);
    REQUIRE_NOTHROW(decoded(bytes));
    for (std::size_t size = 0; size + 2 < bytes.size(); size += 7) {
      CAPTURE(size);
      REQUIRE_THROWS_WITH(decoded(bytes.substr(0, size)), Catch::StartsWith("a.jpg: cannot be read: "));
    }
  }
  std::string restarted = jpeg_file(colored);
  restarted.replace(restarted.size() - 100, 2, "\xff\xd9");  // The end, before the data's.
  CHECK_THROWS_WITH(decoded(restarted), Catch::StartsWith("a.jpg: cannot be read: "));
  CHECK_THROWS_WITH(decoded("no picture"), Catch::StartsWith("a.jpg: cannot be read: Not a JPEG file"));
}

TEST_CASE("what does no harm in a JPEG is passed over") {
  std::string bytes = jpeg_file(colored);
  bytes.insert(2, "rest of another segment");
  bytes += "and of another file";
  CHECK_NOTHROW(decoded(bytes));
}

TEST_CASE("a JPEG that its reader does not want is refused before its pixels are read") {
  const std::string bytes = jpeg_file(colored), name = "a.jpg";
  CHECK_THROWS_WITH(decode_jpeg({bytes, name}, [](const PictureHeader&) { throw Error("too large here"); }),
                    "too large here");
}

}  // namespace twinray::test

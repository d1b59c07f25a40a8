// SPDX-License-Identifier: Apache-2.0
// Radiance pictures, as decode_image gives them.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "io/picture/image_file.h"
#include "tests/support/catch.h"

namespace twinray::test {

TEST_CASE("a Radiance picture has its rows and columns as its header says, and its light without exposure") {
  // Two rows of two pixels: the bytes of each are those of its channels and the exponent of all.
  const std::string pixels("\x80\0\0\x81\0\x80\0\x81\0\0\x80\x81\x80\x80\x80\x81", 16);
  const auto read = [&](const std::string& lines, const std::string& size) {
    return decode_image("#?RADIANCE\n" + lines + "\n" + size + "\n" + pixels, "a.hdr").pixels;
  };
  const std::string plain = "FORMAT=32-bit_rle_rgbe\n";
  const Rgb red{1, 0, 0}, green{0, 1, 0}, blue{0, 0, 1};
  CHECK(read(plain, "-Y 2 +X 2") == std::vector<Rgb>{red, green, blue, white});
  CHECK(read(plain, "+Y 2 +X 2") == std::vector<Rgb>{blue, white, red, green});
  CHECK(read(plain, "-Y 2 -X 2") == std::vector<Rgb>{green, red, white, blue});
  CHECK(read(plain, "+Y 2 -X 2") == std::vector<Rgb>{white, blue, green, red});
  CHECK(read(plain + "EXPOSURE= 2\nEXPOSURE=0.25\n", "-Y 2 +X 2")[0] == Rgb{2, 0, 0});
  CHECK(read(plain + "EXPOSURE=x\n", "-Y 2 +X 2")[0] == red);
  CHECK(read(plain + "COLORCORR= 2 4  8\nEXPOSURE=0.5\n", "-Y 2 +X 2")[3] == Rgb{1, 0.5f, 0.25f});
  CHECK_THROWS_WITH(read(plain, "+X 2 -Y 2"), Catch::Contains("its rows run from top to bottom"));
}

TEST_CASE("a Radiance picture may repeat its pixels as older files do") {
  const std::string red("\x80\0\0\x81", 4), green("\0\x80\0\x81", 4);
  const auto repeat = [](int count) { return std::string("\1\1\1") + char(count); };
  const auto read = [&](int width, const std::string& rows) {
    return decode_image(fmt::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X {}\n", width) + rows,
                        "a.hdr");
  };
  const auto count = [](const Image& image, const Rgb& color) {
    return std::count(image.pixels.begin(), image.pixels.end(), color);
  };
  const Image few = read(5, red + repeat(2) + green + green + green + repeat(4));
  CHECK(count(few, {1, 0, 0}) == 3);
  CHECK(few.at(2, 0) == Rgb{1, 0, 0});
  CHECK(few.at(3, 0) == Rgb{0, 1, 0});
  CHECK(few.at(4, 1) == Rgb{0, 1, 0});
  // 44 + 256 repetitions of green, and a row of one colour.
  const Image many =
      read(308, red + repeat(6) + green + repeat(44) + repeat(1) + red + repeat(51) + repeat(1));
  CHECK(count(many, {1, 0, 0}) == 7 + 308);
  CHECK(count(many, {0, 1, 0}) == 301);
  for (const std::string& rows : {repeat(5) + red, red + repeat(5) + red, red + repeat(2) + green})
    CHECK_THROWS_WITH(read(5, rows), Catch::Contains("a.hdr: cannot be read"));
}

}  // namespace twinray::test

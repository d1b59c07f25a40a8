// SPDX-License-Identifier: Apache-2.0
// PFM and TGA pictures, whose bytes are written here.
#include "io/picture/plain_picture.h"

#include <string>

#include "io/picture/image_file.h"
#include "tests/support/catch.h"

namespace twinray::test {

TEST_CASE("PFM pictures are read from the bottom up, in both byte orders") {
  const auto pixel = [](const char(&raw)[13]) { return std::string(raw, 12); };
  const std::string one = pixel("\x00\x00\x80\x3f\x00\x00\x00\x40\x00\x00\x00\x00");  // 1 2 0
  const std::string zero(12, '\0');
  const Image image = decode_image("PF\n1 2\n-1.0\n" + zero + one, "a.pfm");
  CHECK(image.at(0, 0) == Rgb{1, 2, 0});
  CHECK(image.at(0, 1) == Rgb{0, 0, 0});
  CHECK(decode_image(std::string("Pf 1 1 1\n\x3f\x80\x00\x00", 13), "a.pfm").at(0, 0) == Rgb{1, 1, 1});
  CHECK(decode_image("PF\n1 1\n-2.5\n" + one, "a.pfm").at(0, 0) == Rgb{2.5f, 5, 0});
  CHECK(decode_image("PF\r\n1 1\r\n-1\r\n" + one, "a.pfm").at(0, 0) == Rgb{1, 2, 0});
  for (const std::string scale : {"x", "0", "nan", "-"})
    CHECK_THROWS_WITH(decode_image("PF\n1 1\n" + scale + "\n" + one, "a.pfm"),
                      "a.pfm: cannot be read: its header ends in no scale such as -1.0");
  CHECK_THROWS_WITH(decode_image("PF\n1 2\n-1.0\n" + one, "a.pfm"), "a.pfm: cannot be read: it is cut off");
  CHECK_THROWS_WITH(decode_image("PF\n1 x\n-1.0\n" + one, "a.pfm"),
                    "a.pfm: cannot be read: its header states no size");
}

TEST_CASE("TGA pictures are read, packed in runs or not, from the bottom or the top") {
  const auto header = [](char kind, char width, char height, char depth, char order) {
    std::string bytes(18, '\0');
    bytes[2] = kind, bytes[12] = width, bytes[14] = height, bytes[16] = depth, bytes[17] = order;
    return bytes;
  };
  const std::string blue{'\xff', '\0', '\0'}, red{'\0', '\0', '\xff'};
  const Image plain = decode_image(header(2, 1, 2, 24, 0) + blue + red, "a.tga");
  CHECK(plain.at(0, 0) == Rgb{1, 0, 0});
  CHECK(plain.at(0, 1) == Rgb{0, 0, 1});
  const Image packed =
      decode_image(header(10, 3, 1, 24, 32) + "\x81" + red + std::string(1, '\0') + blue, "a.tga");
  CHECK(packed.at(1, 0) == Rgb{1, 0, 0});
  CHECK(packed.at(2, 0) == Rgb{0, 0, 1});
  CHECK(decode_image(header(3, 1, 1, 8, 0) + "\xff", "a.tga").at(0, 0) == Rgb{1, 1, 1});
  // An alpha of 0 everywhere means nothing where the header says that none of its bits does.
  const ReadOptions alpha{.channels = PictureChannels::alpha};
  const std::string clear = blue + std::string(1, '\0'), opaque = red + "\xff";
  CHECK(decode_image(header(2, 1, 2, 32, 0) + clear + clear, "a.tga", alpha).at(0, 0) == white);
  CHECK(decode_image(header(2, 1, 2, 32, 8) + clear + clear, "a.tga", alpha).at(0, 0) == Rgb{});
  CHECK(decode_image(header(2, 1, 2, 32, 0) + clear + opaque, "a.tga", alpha).at(0, 1) == Rgb{});
  CHECK_THROWS_WITH(decode_image(header(2, 1, 2, 24, 0) + blue, "a.tga"),
                    "a.tga: cannot be read: it is cut off");
  CHECK_THROWS_WITH(
      decode_image(header(1, 1, 1, 8, 0) + "\xff", "a.tga"),
      "a.tga: cannot be read: TGA pictures are read of 24 or 32 bits a pixel, or 8 of grey, without a "
      "palette");
}

}  // namespace twinray::test

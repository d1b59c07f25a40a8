// SPDX-License-Identifier: Apache-2.0
#include "io/cs184/picture.h"

#include <limits>

#include "tests/support/catch.h"

namespace twinray {
namespace {

using Bytes = std::array<std::uint8_t, 3>;
constexpr Bytes blue{0, 0, 255}, green{0, 255, 0}, red{255, 0, 0};

Bytes bytes_at(const ByteImage& image, int x, int y) {
  const std::size_t i = 3 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x));
  return {image.bytes[i], image.bytes[i + 1], image.bytes[i + 2]};
}

}  // namespace

TEST_CASE("CS184's tone curve doubles by the root of 2, and cuts off") {
  CHECK(encode_cs184(0) == 0);
  CHECK(encode_cs184(0.001f) == 12);    // (0.00141421)^(1/2.2) = 0.0506714
  CHECK(encode_cs184(0.25f) == 158);    // 0.623371, and 158.96 is not rounded up
  CHECK(encode_cs184(0.5f) == 217);     // 0.854241
  CHECK(encode_cs184(0.7071f) == 254);  // just below 1 / sqrt(2)
  CHECK(encode_cs184(0.7072f) == 255);
  CHECK(encode_cs184(1e9f) == 255);
  CHECK(encode_cs184(std::numeric_limits<float>::infinity()) == 255);
  CHECK(encode_cs184(-1) == 0);
  CHECK(encode_cs184(std::numeric_limits<float>::quiet_NaN()) == 0);
}

TEST_CASE("an image keeps its shape under CS184's tone curve") {
  Image image(2, 3);
  image.at(1, 2) = {0.25f, 0.5f, 1};
  const ByteImage bytes = encode_cs184(image);
  CHECK(bytes.width == 2);
  CHECK(bytes.height == 3);
  REQUIRE(bytes.bytes.size() == 18);
  CHECK(bytes_at(bytes, 1, 2) == Bytes{158, 217, 255});
  CHECK(bytes_at(bytes, 0, 2) == Bytes{0, 0, 0});
}

TEST_CASE("the picture of sample rates is of the whole frame, blue where nothing was rendered") {
  Film film(4, 3, {1, 1, 3, 2});
  for (std::uint32_t i = 0; i < 8; ++i) film.add(1, 1, i, {});
  for (std::uint32_t i = 0; i < 4; ++i) film.add(2, 1, i, {});
  const ByteImage rates = cs184_rate_image(film, 8);
  CHECK(rates.width == 4);
  CHECK(rates.height == 3);
  REQUIRE(rates.bytes.size() == 36);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 4; ++x) {
      CAPTURE(x, y);
      CHECK(bytes_at(rates, x, y) == (y != 1 || x == 0 || x == 3 ? blue : x == 1 ? red : green));
    }
}

TEST_CASE("the picture of sample rates has the picture's name without its last four characters") {
  CHECK(cs184_rate_name("bunny.png") == "bunny_rate.png");
  CHECK(cs184_rate_name("out.d/bunny.exr") == "out.d/bunny_rate.png");
  CHECK(cs184_rate_name("spheres") == "sph_rate.png");
  CHECK(cs184_rate_name("abcd") == "_rate.png");
  CHECK(cs184_rate_name("a6") == "a6_rate.png");
  CHECK(cs184_rate_name("pictures/a6") == "pictures/a6_rate.png");
}

TEST_CASE("cells count from the bottom left") {
  CHECK(cs184_cell(0, 0, 480, 360, 360) == PixelRect{0, 0, 480, 360});
  CHECK(cs184_cell(100, 50, 30, 20, 360) == PixelRect{100, 290, 130, 310});
  CHECK(cs184_cell(0, 0, 1, 1, 360) == PixelRect{0, 359, 1, 360});
}

}  // namespace twinray

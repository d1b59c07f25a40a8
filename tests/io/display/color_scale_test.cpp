// SPDX-License-Identifier: Apache-2.0
#include "io/display/color_scale.h"

#include <cmath>
#include <limits>

#include "tests/support/catch.h"

using namespace twinray;

namespace {

/// The matrix to cone responses is printed with ten digits, floats have seven.
constexpr double rounding = 1e-4;

/// OKLab's lightness of a linear colour, by the published way from sRGB.
double oklab_lightness(const Rgb& c) {
  const double l = std::cbrt(0.4122214708 * c.r + 0.5363325363 * c.g + 0.0514459929 * c.b);
  const double m = std::cbrt(0.2119034982 * c.r + 0.6806995451 * c.g + 0.1073969566 * c.b);
  const double s = std::cbrt(0.0883024619 * c.r + 0.2817188376 * c.g + 0.6299787005 * c.b);
  return 0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s;
}

Image grey(float value) {
  Image image(2, 1);
  image.at(1, 0) = {value, value, value};
  return image;
}

std::array<std::uint8_t, 3> color_at(const ByteImage& image, int x, int y) {
  const std::size_t i = 3 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x));
  return {image.bytes[i], image.bytes[i + 1], image.bytes[i + 2]};
}

std::array<std::uint8_t, 3> encoded(const Rgb& c) {
  return {encode_srgb(c.r), encode_srgb(c.g), encode_srgb(c.b)};
}

TEST_CASE("a signed colour is blue below 0, white at 0 and red above, and ends at 1") {
  using Bytes = std::array<std::uint8_t, 3>;
  CHECK(signed_color(0) == Bytes{255, 255, 255});
  CHECK(signed_color(-0.5) == Bytes{128, 166, 217});
  CHECK(signed_color(1) == Bytes{191, 13, 26});
  CHECK(signed_color(7) == signed_color(1));
  CHECK(signed_color(-7) == Bytes{0, 77, 178});
  CHECK(signed_color(std::nan("")) == Bytes{255, 255, 255});
}

}  // namespace

TEST_CASE("the scale grows evenly in lightness, and sRGB holds all of it") {
  for (int i = 0; i <= 256; ++i) {
    const float x = float(i) / 256;
    const Rgb c = scale_color(x);
    CAPTURE(x, c.r, c.g, c.b);
    CHECK(oklab_lightness(c) == Approx(0.2 + 0.75 * x).margin(rounding));
    CHECK(std::min(c.r, std::min(c.g, c.b)) >= 0);
    CHECK(max_component(c) <= 1);
  }
}

TEST_CASE("the scale goes from violet over green to yellow, and ends there") {
  const Rgb violet = scale_color(0), green = scale_color(0.6f), yellow = scale_color(1);
  CHECK(violet.b > violet.r);
  CHECK(violet.r > violet.g);
  CHECK(green.g > 2 * green.r);
  CHECK(yellow.r > yellow.b);
  CHECK(yellow.g > yellow.b);
  CHECK(scale_color(-1) == violet);
  CHECK(scale_color(std::numeric_limits<float>::quiet_NaN()) == violet);
  CHECK(scale_color(7) == yellow);
}

TEST_CASE("a scale ends at the next of 5, 10, 20, 50") {
  CHECK(scale_end(Image(3, 3)) == 5);
  CHECK(scale_end(grey(5)) == 5);
  CHECK(scale_end(grey(5.5f)) == 10);
  CHECK(scale_end(grey(11)) == 20);
  CHECK(scale_end(grey(20.5f)) == 50);
  CHECK(scale_end(grey(51)) == 100);
  CHECK(scale_end(grey(10060)) == 20000);
  CHECK(scale_end(grey(1e9f)) == 1000000000);
}

TEST_CASE("an image on the scale has the colour of each value's share") {
  const ByteImage image = scaled_image(grey(5), 20);
  CHECK(image.width == 2);
  CHECK(image.height == 1);
  CHECK(color_at(image, 0, 0) == encoded(scale_color(0)));
  CHECK(color_at(image, 1, 0) == encoded(scale_color(0.25f)));
}

TEST_CASE("the legend has the scale from below to above, six ticks and six numbers") {
  const ByteImage legend = legend_image(5);
  CHECK(legend.width == 116);
  CHECK(legend.height == 221);
  REQUIRE(legend.bytes.size() == 3 * 116 * 221);
  CHECK(color_at(legend, 12, 210) == encoded(scale_color(0)));
  CHECK(color_at(legend, 12, 110) == encoded(scale_color(0.5f)));
  CHECK(color_at(legend, 12, 10) == encoded(scale_color(1)));
  CHECK(color_at(legend, 0, 0) == std::array<std::uint8_t, 3>{255, 255, 255});
  int black = 0;
  for (int y = 0; y < legend.height; ++y)
    for (int x = 0; x < legend.width; ++x)
      black += color_at(legend, x, y) == std::array<std::uint8_t, 3>{0, 0, 0};
  // The digits 0 to 5 have 12 + 8 + 11 + 11 + 9 + 11 dots of 2 x 2 pixels, and a tick has four.
  CHECK(black == 4 * (12 + 8 + 11 + 11 + 9 + 11) + 6 * 4);
  CHECK(legend_image(1000000000).bytes.size() == legend.bytes.size());
}

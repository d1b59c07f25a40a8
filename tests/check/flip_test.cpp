// SPDX-License-Identifier: Apache-2.0
// FLIP against its authors' program: the numbers are those of flip-evaluator 1.7 (PyPI) for the same
// pictures.
#include "check/flip.h"

#include <algorithm>
#include <array>

#include "core/error.h"
#include "tests/support/catch.h"

namespace twinray::test {
namespace {

constexpr int columns = 64, rows = 48;
/// The program computes in floats, and blurs in another order.
constexpr double rounding = 2e-5;

/// Two slopes and a board of squares.
Image reference() {
  Image image(columns, rows);
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x)
      image.at(x, y) = {float(x) / 63, float(y) / 47, (x / 8 + y / 8) % 2 ? 0.75f : 0.25f};
  return image;
}

/// With noise in red, and too little blue on the right.
Image picture() {
  Image image = reference();
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      Rgb& pixel = image.at(x, y);
      pixel.r = std::clamp(pixel.r + float((x * 37 + y * 101) % 17 - 8) / 100, 0.0f, 1.0f);
      if (x >= columns / 2) pixel.b *= 0.9f;
    }
  return image;
}

/// Four times as bright, with a spot of this colour.
Image radiance(Image image, const Rgb& spot) {
  for (Rgb& pixel : image.pixels) pixel = 4 * pixel;
  for (const int y : {10, 11})
    for (const int x : {20, 21}) image.at(x, y) = spot;
  return image;
}

Image filled(const Rgb& color) { return Image(columns, rows, color); }

/// What the authors' program says of a map.
struct Expected {
  double mean, largest;
  std::array<double, 4> pixels;  ///< (0, 0), (31, 20), (63, 47), (40, 24)
};

void check_map(const FlipMap& map, const Expected& expected) {
  CHECK(mean_of(map) == Approx(expected.mean).margin(rounding));
  CHECK(*std::max_element(map.values.begin(), map.values.end()) == Approx(expected.largest).margin(rounding));
  CHECK(map.row(0)[0] == Approx(expected.pixels[0]).margin(rounding));
  CHECK(map.row(20)[31] == Approx(expected.pixels[1]).margin(rounding));
  CHECK(map.row(47)[63] == Approx(expected.pixels[2]).margin(rounding));
  CHECK(map.row(24)[40] == Approx(expected.pixels[3]).margin(rounding));
}

}  // namespace

TEST_CASE("FLIP of displayed pictures is that of its authors' program") {
  check_map(ldr_flip(picture(), reference()),
            {0.1093204, 0.208724, {0.100275, 0.086626, 0.147928, 0.142621}});
}

TEST_CASE("FLIP of a picture seen from near by is that of its authors' program") {
  check_map(ldr_flip(picture(), reference(), 20),
            {0.1574517, 0.327725, {0.020996, 0.099419, 0.127248, 0.169633}});
}

TEST_CASE("FLIP of radiance is that of its authors' program") {
  const Image converged = radiance(reference(), {200, 150, 100});
  const FlipExposures exposures = flip_exposures(converged);
  CHECK(exposures.first == Approx(-6.2115073).margin(1e-6));
  CHECK(exposures.last == Approx(0.0769840).margin(1e-6));
  CHECK(exposures.count == 7);
  check_map(hdr_flip(radiance(picture(), {100, 150, 100}), converged),
            {0.1063212, 0.364490, {0.210351, 0.078797, 0.139214, 0.105333}});
}

TEST_CASE("FLIP of a display's most different colours is 1, of black and white nearly") {
  CHECK(mean_of(ldr_flip(filled({0, 1, 0}), filled({0, 0, 1}))) == Approx(1).margin(rounding));
  CHECK(mean_of(ldr_flip(filled({}), filled({1, 1, 1}))) == Approx(0.967388).margin(rounding));
}

TEST_CASE("FLIP of equal pictures is 0, however bright or dark") {
  for (const Rgb& color : {Rgb{}, Rgb{0.2f, 0.5f, 0.1f}, Rgb{1e9f, 1e9f, 1e9f}, Rgb{-1, 0, 1}}) {
    CHECK(mean_of(ldr_flip(filled(color), filled(color))) == 0);
    CHECK(mean_of(hdr_flip(filled(color), filled(color))) == 0);
  }
}

TEST_CASE("what is brighter than any display differs as what is white, also near the end of all numbers") {
  const Image reference = filled({0.5f, 0.25f, 1});
  const double white = mean_of(hdr_flip(filled({1e12f, 1e12f, 1e12f}), reference));
  CHECK(white > 0.3);
  for (const float bright : {1e20f, 1e38f, 3e38f})
    CHECK(mean_of(hdr_flip(filled({bright, bright, bright}), reference)) == Approx(white));
}

TEST_CASE("FLIP of radiance takes negative channels for black") {
  CHECK(hdr_flip(filled({0.5f, -3, 0.5f}), filled({0.5f, 0.5f, 0.5f})).values ==
        hdr_flip(filled({0.5f, 0, 0.5f}), filled({0.5f, 0.5f, 0.5f})).values);
}

TEST_CASE("FLIP takes a single exposure of a black reference, and 23 where most pixels are black") {
  CHECK(flip_exposures(filled({})).count == 1);
  Image half = reference();
  for (Rgb& pixel : half.pixels) pixel = {1, 1, 1};
  std::fill(half.pixels.begin(), half.pixels.begin() + columns * rows / 2, Rgb{});
  CHECK(flip_exposures(half).first == Approx(1.0832935).margin(1e-6));
  CHECK(flip_exposures(half).count == 2);
  half.pixels[columns * rows / 2] = {};
  CHECK(flip_exposures(half).last == Approx(24.0832935).margin(1e-6));
  CHECK(flip_exposures(half).count == 23);
}

TEST_CASE("a picture of one pixel has a FLIP map, and pictures of different sizes none") {
  CHECK(ldr_flip(Image(1, 1), Image(1, 1)).values == std::vector<float>{0});
  CHECK_THROWS_AS(ldr_flip(Image(2, 1), Image(1, 2)), Error);
  CHECK_THROWS_AS(hdr_flip(Image(2, 1), Image(1, 2)), Error);
}

}  // namespace twinray::test

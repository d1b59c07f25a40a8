// SPDX-License-Identifier: Apache-2.0
#include "check/picture_difference.h"

#include "check/tiles.h"
#include "core/error.h"
#include "tests/support/catch.h"

namespace twinray::test {
namespace {

Image small_picture_of(const Rgb& color) { return Image(20, 20, color); }

}  // namespace

TEST_CASE("differences are the picture's values minus the reference's, by channel and over all") {
  const Image reference = small_picture_of({1, 2, 0});
  Image picture = reference;
  picture.at(3, 7) = {1, 2, 4};
  picture.at(4, 7) = {0, 2, 0};
  const PictureDifference difference = picture_difference(picture, reference);
  CHECK(difference.channels[0].squared.mse == Approx(1.0 / 400));
  CHECK(difference.channels[0].squared.relative == Approx(1.0 / 1.01 / 400));
  CHECK(difference.channels[0].mean == Approx(-1.0 / 400));
  CHECK(difference.channels[1].squared.mse == 0);
  CHECK(difference.channels[2].squared.mse == Approx(16.0 / 400));
  CHECK(difference.channels[2].squared.relative == Approx(16 / 0.01 / 400));
  CHECK(difference.channels[2].mean == Approx(4.0 / 400));
  CHECK(difference.channels[1].reference_mean == Approx(2));
  CHECK(difference.all.squared.mse == Approx(17.0 / 1200));
  CHECK(difference.all.mean == Approx(3.0 / 1200));
  CHECK(difference.all.reference_mean == Approx(1));
  CHECK(difference.differing_pixels == 2);
  CHECK(difference.largest.x == 3);
  CHECK(difference.largest.y == 7);
  CHECK(difference.largest.channel == 2);
  CHECK(difference.largest.value == 4);
}

TEST_CASE("the mean squared error and its relative are those of error") {
  Image picture = small_picture_of({0.3f, 0.5f, 0.1f});
  picture.at(0, 0) = {4, 1, 0};
  const Image reference = small_picture_of({0.25f, 0.5f, 0.2f});
  const SquaredError expected =
      squared_error(picture, {reference, {}}, PixelMask(reference.pixels.size(), 1));
  const PictureDifference difference = picture_difference(picture, reference);
  CHECK(difference.all.squared.mse == Approx(expected.mse));
  CHECK(difference.all.squared.relative == Approx(expected.relative));
}

TEST_CASE("a darker picture has a largest difference below 0") {
  Image picture = small_picture_of({1, 1, 1});
  picture.at(19, 19).g = -2;
  CHECK(picture_difference(picture, small_picture_of({1, 1, 1})).largest.value == -3);
}

TEST_CASE("tiles cover a picture once, the last ones as far as it goes") {
  const std::vector<PixelRect> tiles = tiles_of(20, 17, 16);
  REQUIRE(tiles.size() == 4);
  int pixels = 0;
  for (const PixelRect& tile : tiles) pixels += tile.width() * tile.height();
  CHECK(pixels == 20 * 17);
  CHECK(tiles[3].x0 == 16);
  CHECK(tiles[3].y1 == 17);
}

TEST_CASE("the tiles that differ most come first, and those that are equal not at all") {
  const Image reference = small_picture_of({1, 1, 1});
  Image picture = reference;
  picture.at(0, 0) = {3, 1, 1};    // 4 / (3 256)
  picture.at(18, 18) = {1, 0, 1};  // 1 / (3 16)
  const std::vector<TileDifference> tiles = largest_differences(picture, reference, 8);
  REQUIRE(tiles.size() == 2);
  CHECK(tiles[0].tile.x0 == 16);
  CHECK(tiles[0].tile.y0 == 16);
  CHECK(tiles[0].mse == Approx(1.0 / 48));
  CHECK(tiles[0].luminance == Approx(-0.7152 / 16));
  CHECK(tiles[1].mse == Approx(4.0 / 768));
  CHECK(tiles[1].luminance == Approx(2 * 0.2126 / 256));
  CHECK(largest_differences(picture, reference, 1).size() == 1);
}

TEST_CASE("the peak signal-to-noise ratio is of 8 bits") {
  const ByteImage black{2, 1, {0, 0, 0, 0, 0, 0}}, white{2, 1, {255, 255, 255, 255, 255, 255}};
  CHECK(*peak_signal_to_noise(white, black) == Approx(0).margin(1e-12));
  CHECK(*peak_signal_to_noise({2, 1, {0, 0, 0, 0, 0, 1}}, black) == Approx(55.9123).epsilon(1e-6));
  CHECK_FALSE(peak_signal_to_noise(black, black).has_value());
}

TEST_CASE("pictures of different sizes, or without a pixel, have no difference") {
  for (const Image& other : {Image(1, 1), Image(2, 2), Image(1, 2)})
    CHECK_THROWS_WITH(picture_difference(Image(2, 1), other),
                      "pictures of different sizes cannot be compared");
  CHECK_THROWS_WITH(picture_difference(Image(), Image()), "pictures without pixels cannot be compared");
  CHECK_THROWS_AS(largest_differences(Image(2, 1), Image(1, 2), 8), Error);
  CHECK_THROWS_AS(peak_signal_to_noise({1, 1, {0, 0, 0}}, {2, 1, {0, 0, 0, 0, 0, 0}}), Error);
}

}  // namespace twinray::test

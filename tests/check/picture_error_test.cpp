// SPDX-License-Identifier: Apache-2.0
#include "check/picture_error.h"

#include "tests/support/catch.h"

namespace twinray::test {
namespace {

Image row_of(const std::vector<Rgb>& pixels) {
  Image image(int(pixels.size()), 1);
  image.pixels = pixels;
  return image;
}

}  // namespace

TEST_CASE("errors are means over the pixels that count and their channels") {
  const ConvergedPicture converged{row_of({{1, 2, 0}, {5, 5, 5}}), {}};
  const Image image = row_of({{1.5f, 2, 1}, {100, 0, 0}});
  const SquaredError error = squared_error(image, converged, {1, 0});
  CHECK(error.mse == Approx((0.25 + 0 + 1) / 3));
  CHECK(error.relative == Approx((0.25 / 1.01 + 0 + 1 / 0.01) / 3));
  CHECK(squared_error(image, converged, {1, 1}).mse == Approx((1.25 + 95 * 95 + 25 + 25) / 6));
  CHECK(squared_error(image, converged, {0, 0}).mse == 0);
}

TEST_CASE("two halves give a mean, and their difference its own error") {
  const ConvergedPicture converged =
      converged_picture(row_of({{1, 1, 1}, {3, 0, 0}}), row_of({{2, 1, 1}, {1, 0, 0}}));
  CHECK(converged.mean.pixels[0] == Rgb{1.5f, 1, 1});
  CHECK(converged.mean.pixels[1] == Rgb{2, 0, 0});
  CHECK(own_error(converged, {1, 1}).mse == Approx((0.25 + 1) / 6));
  CHECK(own_error(converged, {1, 0}).mse == Approx(0.25 / 3));
  CHECK(own_error(converged, {1, 0}).relative == Approx(0.25 / 2.26 / 3));
  CHECK(own_error({converged.mean, {}}, {1, 1}).mse == 0);
}

TEST_CASE("pictures and masks of different sizes are not compared") {
  const ConvergedPicture converged{Image(2, 1), {}};
  CHECK_THROWS_WITH(squared_error(Image(1, 2), converged, {1, 1}),
                    "pictures of different sizes cannot be compared");
  CHECK_THROWS_WITH(squared_error(Image(2, 1), converged, {1}), "the mask has another size than the picture");
}

}  // namespace twinray::test

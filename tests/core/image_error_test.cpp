// SPDX-License-Identifier: Apache-2.0
#include "core/image_error.h"

#include "core/error.h"
#include "tests/support/catch.h"

namespace twinray {
namespace {

/// Grey pixels: their luminance is their value, up to the rounding of three weights that add up to 1.
Image grey_picture(std::vector<float> values) {
  Image image(int(values.size()), 1);
  for (std::size_t i = 0; i < values.size(); ++i) image.pixels[i] = {values[i], values[i], values[i]};
  return image;
}

/// Of sums of a few floats.
constexpr double of_weights = 1e-6;

}  // namespace

TEST_CASE(
    "an error is the root mean square over the converged picture's mean, and has a sign in brightness") {
  const ImageError error = image_error(grey_picture({1, 2, 3, 2}), grey_picture({1, 4, 3, 4}));
  CHECK(error.relative == Approx(1.41421356 / 3).epsilon(of_weights));
  CHECK(error.brightness == Approx(-1.0 / 3).epsilon(of_weights));
}

TEST_CASE("a black picture is wrong by all of the light, and equal pictures not at all") {
  CHECK(image_error(grey_picture({0, 0}), grey_picture({2, 2})).relative == Approx(1).epsilon(of_weights));
  CHECK(image_error(grey_picture({0, 0}), grey_picture({2, 2})).brightness == -1);
  CHECK(image_error(grey_picture({0.5f, 2}), grey_picture({0.5f, 2})).relative == 0);
  CHECK(image_error(grey_picture({1, 1}), grey_picture({0, 0})).relative == 0);
}

TEST_CASE("pictures of different sizes have no error, but are one") {
  CHECK_THROWS_AS(image_error(grey_picture({1, 1}), grey_picture({1, 1, 1})), Error);
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "core/image.h"

#include "tests/support/catch.h"

namespace twinray {

TEST_CASE("a mean image has the window's pixels, from the top left") {
  Film film(10, 8, {2, 3, 5, 5});
  film.add(2, 3, 0, {1, 2, 3});
  film.add(2, 3, 1, {3, 2, 1});
  film.add(4, 4, 0, {0.5f, 0, 0});
  const Image image = mean_image(film);
  CHECK(image.width == 3);
  CHECK(image.height == 2);
  CHECK(image.at(0, 0) == Rgb{2, 2, 2});
  CHECK(image.at(2, 1) == Rgb{0.5f, 0, 0});
  CHECK(image.at(1, 0) == Rgb{});
}

TEST_CASE("sample rates run from blue over green to red") {
  using Color = std::array<std::uint8_t, 3>;
  CHECK(rate_color(0) == Color{0, 0, 255});
  CHECK(rate_color(0.25f) == Color{0, 127, 127});
  CHECK(rate_color(0.5f) == Color{0, 255, 0});
  CHECK(rate_color(0.75f) == Color{127, 127, 0});
  CHECK(rate_color(1) == Color{255, 0, 0});
}

TEST_CASE("the sample-rate picture shows samples made over samples allowed") {
  Film film(2, 1, {0, 0, 2, 1});
  for (std::uint32_t i = 0; i < 4; ++i) film.add(0, 0, i, {1, 1, 1});
  for (std::uint32_t i = 0; i < 8; ++i) film.add(1, 0, i, {1, 1, 1});
  CHECK(sample_rate_image(film, 8).bytes == std::vector<std::uint8_t>{0, 255, 0, 255, 0, 0});
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "core/mip_map.h"

#include "tests/support/catch.h"
#include "tests/support/random.h"

namespace twinray::test {
namespace {

Image random_image(int width, int height) {
  Image image(width, height);
  Random random(1);
  for (Rgb& pixel : image.pixels) pixel = {random.unit(), random.unit(), 10 * random.unit()};
  return image;
}

double mean_blue(const Image& image) {
  double sum = 0;
  for (const Rgb& pixel : image.pixels) sum += pixel.b;
  return sum / double(image.pixels.size());
}

}  // namespace

TEST_CASE("a mip-map halves down to one pixel, and each level has the picture's mean") {
  for (const auto& [width, height] :
       {std::pair{64, 64}, std::pair{37, 10}, std::pair{1, 9}, std::pair{1, 1}}) {
    CAPTURE(width, height);
    const Image picture = random_image(width, height);
    const MipMap map(picture);
    CHECK(map.image(0).pixels == picture.pixels);
    CHECK(map.image(map.levels() - 1).pixels.size() == 1);
    for (int level = 1; level < map.levels(); ++level) {
      const Image image = map.image(level), before = map.image(level - 1);
      CHECK(image.width == std::max(before.width / 2, 1));
      CHECK(image.height == std::max(before.height / 2, 1));
      CHECK(mean_blue(image) == Approx(mean_blue(picture)).epsilon(1e-6));
    }
  }
}

TEST_CASE("a pixel of a mip-map is the mean of the pixels that it covers, or of their parts") {
  Image row(5, 1);
  for (int x = 0; x < 5; ++x) row.at(x, 0) = {float(1 << x), 0, 0};
  const MipMap map(row);
  // Two pixels for five: two and a half each.
  CHECK(map.level(1).at(0, 0).r == Approx((1 + 2 + 4 / 2.0) / 2.5));
  CHECK(map.level(1).at(1, 0).r == Approx((4 / 2.0 + 8 + 16) / 2.5));
}

}  // namespace twinray::test

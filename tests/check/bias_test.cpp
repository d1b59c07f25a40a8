// SPDX-License-Identifier: Apache-2.0
#include "check/bias.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"
#include "tests/support/statistics.h"

namespace twinray::test {
namespace {

constexpr int width = 160, height = 160, tile = 16;

/// What pixels are on average: from dark to bright.
float expected(std::size_t pixel) { return 0.1f + float(pixel % 97) / 97; }

/// A picture whose pixels have that mean and an exponential distribution over `samples`: skewed, as light is.
Image noisy_picture(std::uint64_t seed, int samples, float factor = 1) {
  Random random(seed);
  Image picture(width, height);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    double sum = 0;
    for (int s = 0; s < samples; ++s) sum -= log2_of(1 - double(random.unit())) * std::numbers::ln2;
    const float value = factor * expected(i) * float(sum / samples);
    picture.pixels[i] = {value, value, value};
  }
  return picture;
}

PictureMoments pictures(std::uint64_t seed, int count, int samples, float factor = 1) {
  PictureMoments moments;
  for (int i = 0; i < count; ++i) moments.add(noisy_picture(seed + std::uint64_t(i), samples, factor));
  return moments;
}

ConvergedPicture converged(std::uint64_t seed, int samples) {
  return converged_picture(noisy_picture(seed, samples / 2), noisy_picture(seed + 1, samples / 2));
}

const PixelMask all_pixels(std::size_t(width) * height, 1);

/// The largest distance of the p-values' distribution from the uniform one (Kolmogorov and Smirnov).
double distance_from_uniform(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  double most = 0;
  const auto n = double(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    most = std::max({most, values[i] - double(i) / n, double(i + 1) / n - values[i]});
  return most;
}

}  // namespace

TEST_CASE("p-values of tiles without bias are uniformly distributed") {
  std::vector<double> values;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const BiasTest test =
        test_bias(pictures(100 * seed, 4, 8), converged(100 * seed + 50, 128), all_pixels, tile);
    CHECK(test.tiles.size() == 100);
    for (const TileTest& one : test.tiles) values.push_back(one.test.p_value);
  }
  // Kolmogorov's limit at the level of 1 %. A variance that is wrong by a quarter would be seen.
  CHECK(distance_from_uniform(values) < 1.63 / std::sqrt(double(values.size())));
}

TEST_CASE("no bias is found where there is none, and one of 1 % is found") {
  const ConvergedPicture reference = converged(7, 256);
  const BiasTest honest = test_bias(pictures(20, 4, 16), reference, all_pixels, tile);
  CHECK(honest.p_value > 0.01);
  CHECK(std::abs(honest.whole.test.t) < 3);
  const BiasTest biased = test_bias(pictures(20, 4, 16, 1.01f), reference, all_pixels, tile);
  CHECK(biased.p_value < 1e-6);
  CHECK(biased.whole.test.t > 5);
  CHECK(biased.whole.picture.mean / biased.whole.converged.mean == Approx(1.01).margin(0.003));
}

TEST_CASE("the p-value of a picture is corrected for all its tiles and the whole") {
  const BiasTest test = test_bias(pictures(20, 4, 16), converged(7, 256), all_pixels, tile);
  double least = test.whole.test.p_value;
  for (const TileTest& one : test.tiles) least = std::min(least, one.test.p_value);
  CHECK(test.p_value == corrected_p_value(least, 101));
}

TEST_CASE("a bias of one tile is found there, though the picture's mean hides it") {
  const ConvergedPicture reference = converged(7, 256);
  PictureMoments moments;
  for (std::uint64_t seed = 30; seed < 34; ++seed) {
    Image picture = noisy_picture(seed, 16);
    for (int y = 32; y < 48; ++y)
      for (int x = 64; x < 80; ++x) picture.at(x, y) = picture.at(x, y) * 1.15f;
    moments.add(picture);
  }
  const BiasTest test = test_bias(moments, reference, all_pixels, tile);
  CHECK(test.p_value < 1e-4);
  CHECK(test.whole.test.p_value > 0.01);
  const auto worst =
      std::min_element(test.tiles.begin(), test.tiles.end(),
                       [](const TileTest& a, const TileTest& b) { return a.test.p_value < b.test.p_value; });
  CHECK(worst->tile == PixelRect{64, 32, 80, 48});
  CHECK(worst->test.t > 0);
}

TEST_CASE("the converged picture's noise counts where it is known, else it is taken for bias") {
  ConvergedPicture rough = converged(7, 16);
  const PictureMoments moments = pictures(20, 4, 64);
  CHECK(test_bias(moments, rough, all_pixels, tile).p_value > 0.01);
  rough.noise.reset();
  CHECK(test_bias(moments, rough, all_pixels, tile).p_value < 1e-6);
}

TEST_CASE("means have the variance of seeds and of halves, over the number of pixels") {
  const auto grey = [](float value) { return Image(2, 2, {value, value, value}); };
  PictureMoments moments;
  for (const float value : {1.0f, 2.0f, 3.0f}) moments.add(grey(value));
  const TileTest whole =
      test_bias(moments, converged_picture(grey(1), grey(1.5f)), PixelMask(4, 1), tile).whole;
  // 1, 2 and 3: a variance of 1, and of their mean 1/3; 2 degrees of freedom a pixel.
  CHECK(whole.picture.mean == Approx(2));
  CHECK(whole.picture.variance == Approx(1.0 / 3 / 4));
  CHECK(whole.picture.freedom == Approx(8));
  // Halves of 1 and 1.5: a variance of 1/8, and of their mean 1/16; 1 degree of freedom a pixel.
  CHECK(whole.converged.mean == Approx(1.25));
  CHECK(whole.converged.variance == Approx(1.0 / 16 / 4));
  CHECK(whole.converged.freedom == Approx(4));
}

TEST_CASE("pixels that do not count, and tiles of them alone, are left out") {
  PixelMask mask = all_pixels;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 24; ++x) mask[std::size_t(y * width + x)] = 0;
  const BiasTest test = test_bias(pictures(20, 2, 4), converged(7, 16), mask, tile);
  CHECK(test.tiles.size() == 99);
  CHECK(test.tiles.front().tile == PixelRect{16, 0, 32, 16});
  CHECK(test.tiles.front().pixels == 128);
  CHECK(test.whole.pixels == all_pixels.size() - 16 * 24);
}

TEST_CASE("tiles at the right and at the bottom are as wide and high as what is left") {
  PictureMoments moments;
  for (int i = 0; i < 2; ++i) moments.add(Image(20, 17));
  const BiasTest test = test_bias(moments, {Image(20, 17), {}}, PixelMask(340, 1), 16);
  CHECK(test.tiles.size() == 4);
  CHECK(test.tiles.back().tile == PixelRect{16, 16, 20, 17});
  CHECK(test.p_value == 1);
}

TEST_CASE("a single picture tells nothing of its noise") {
  CHECK_THROWS_AS(test_bias(pictures(1, 1, 1), converged(7, 2), all_pixels, tile), Error);
  PictureMoments moments = pictures(1, 1, 1);
  CHECK_THROWS_AS(moments.add(Image(2, 2)), Error);
}

}  // namespace twinray::test

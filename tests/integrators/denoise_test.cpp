// SPDX-License-Identifier: Apache-2.0
#include "integrators/denoise/denoise.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/parallel.h"
#include "tests/support/catch.h"
#include "tests/support/half_pictures.h"
#include "tests/support/random.h"

namespace twinray::test {
namespace {

/// What a pixel shows without noise: its colour and its features, which are albedo and normal.
struct Shown {
  Rgb color, albedo;
  Vec3 normal{0, 0, 1};
};
using Motif = std::function<Shown(int x, int y)>;

constexpr int columns = 75, rows = 43;  ///< No multiples of a tile.

Image clean(const Motif& motif) {
  Image image(columns, rows);
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) image.at(x, y) = motif(x, y).color;
  return image;
}

/// Both halves, each with noise of its own: a deviation of the mean of both, as a share of each colour.
HalfPictures with_noise(const Motif& motif, float deviation) {
  const Plane empty(columns, rows);
  HalfPictures noisy{columns, rows, {}, empty};
  Random random(9);
  for (HalfPicture& half : noisy.halves) {
    half.color = {empty, empty, empty};
    half.features.assign(6, empty);
    for (std::size_t i = 0; i < empty.values.size(); ++i) {
      const Shown shown = motif(int(i) % columns, int(i) / columns);
      const float colors[] = {shown.color.r, shown.color.g, shown.color.b};
      const float features[] = {shown.albedo.r, shown.albedo.g, shown.albedo.b,
                                shown.normal.x, shown.normal.y, shown.normal.z};
      const float factor = 1 + deviation * std::sqrt(6.0f) * random.uniform(-1, 1);
      for (std::size_t c = 0; c < 3; ++c) half.color[c].values[i] = colors[c] * factor;
      for (std::size_t f = 0; f < 6; ++f) half.features[f].values[i] = features[f];
    }
  }
  for (float& weight : noisy.second_weight.values) weight = 0.5f;
  return noisy;
}

Image mean_picture(const HalfPictures& pictures) {
  const auto& [a, b] = pictures.halves;
  return image_of(means_of_halves(a.color, b.color, pictures.second_weight));
}

bool everywhere(int, int) { return true; }
bool at_the_border(int x, int y) { return x == 0 || y == 0 || x == columns - 1 || y == rows - 1; }

/// The sum of the squared differences of red, of some of the pixels.
double squared_error(const Image& image, const Motif& motif, bool (*counts)(int x, int y)) {
  const Image should = clean(motif);
  double sum = 0;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x)
      if (counts(x, y)) sum += std::pow(double(image.at(x, y).r) - should.at(x, y).r, 2);
  return sum;
}

/// How much of the noise's squared error is left.
double left_of(const Motif& motif, float deviation, bool (*counts)(int x, int y) = everywhere) {
  const HalfPictures noisy = with_noise(motif, deviation);
  return squared_error(denoised(noisy), motif, counts) / squared_error(mean_picture(noisy), motif, counts);
}

Shown wall(int, int) { return {{0.5f, 0.4f, 0.3f}, {0.8f, 0.8f, 0.8f}}; }

/// Fine stripes of paint, which the albedo shows.
Shown stripes(int x, int) {
  const float paint = x % 4 < 2 ? 0.9f : 0.2f;
  return {{0.6f * paint, 0.6f * paint, 0.6f * paint}, {paint, paint, paint}};
}

/// Paint without any pattern: no pixel has neighbours that look alike, but for what the albedo explains.
Shown speckles(int x, int y) {
  Random random(std::uint64_t(y * columns + x));
  const float paint = random.uniform(0.2f, 0.9f);
  return {{0.6f * paint, 0.6f * paint, 0.6f * paint}, {paint, paint, paint}};
}

/// The edge of a shadow, which no feature shows.
Shown shadow(int x, int y) {
  const float light = 3 * x + y > 130 ? 1.0f : 0.1f;
  return {{light, light, light}, {0.8f, 0.8f, 0.8f}};
}

/// Light that nothing explains: another in each pixel.
Shown glitter(int x, int y) {
  Random random(std::uint64_t(y * columns + x));
  const float light = random.uniform(0.2f, 1.5f);
  return {{light, light, light}, {0.8f, 0.8f, 0.8f}};
}

}  // namespace

TEST_CASE("noise on a wall goes, but for a thirtieth") {
  for (const float deviation : {0.02f, 0.2f}) CHECK(left_of(wall, deviation) < 1.0 / 30);
}

TEST_CASE("a texture that the albedo shows stays, and its noise goes") {
  CHECK(left_of(stripes, 0.1f) < 0.05);
}

TEST_CASE("a texture that has no pattern is known by its albedo alone") {
  CHECK(left_of(speckles, 0.3f) < 0.1);
}

TEST_CASE("noise at the border of a picture goes nearly as it does elsewhere") {
  CHECK(left_of(wall, 0.2f, at_the_border) < 0.03);
}

TEST_CASE("light below nothing, as a pixel filter may leave it, becomes none") {
  const Motif motif = [](int x, int y) {
    Shown shown = wall(x, y);
    if (x % 20 == 7) shown.color = {-0.1f, -0.2f, 0.3f};
    return shown;
  };
  for (const float deviation : {0.0f, 0.1f})
    for (const Rgb& pixel : denoised(with_noise(motif, deviation)).pixels)
      CHECK(std::min({pixel.r, pixel.g, pixel.b}) >= 0);
}

TEST_CASE("an edge that no feature shows stays, and the noise around it goes") {
  CHECK(left_of(shadow, 0.1f) < 0.15);
  const Image image = denoised(with_noise(shadow, 0.1f));
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const float light = shadow(x, y).color.r;
      CHECK(std::fabs(image.at(x, y).r - light) < 0.35f * light);  // The noise alone reaches 17 %.
    }
}

TEST_CASE("what cannot be told from noise is not made worse than the noise by a tenth") {
  for (const float deviation : {0.3f, 0.1f, 0.03f, 0.01f, 0.003f}) {
    CAPTURE(deviation);
    CHECK(left_of(glitter, deviation) < 1.1);
  }
}

TEST_CASE("faint light that nothing explains is left in its noise, where filters would take both") {
  for (const float strength : {1.0f, 1.5f, 2.0f, 3.0f}) {
    constexpr float deviation = 0.05f;
    const Motif faint = [&](int x, int y) {
      Random random(std::uint64_t(y * columns + x));
      const float light = 1 + strength * deviation * (random.unit() < 0.5f ? -1 : 1);
      return Shown{{light, light, light}, {0.8f, 0.8f, 0.8f}};
    };
    CAPTURE(strength);
    CHECK(left_of(faint, deviation) < 1.1);
  }
}

TEST_CASE("a picture without noise keeps its bits") {
  for (const auto& motif : {wall, stripes, shadow, glitter})
    CHECK(denoised(with_noise(motif, 0)).pixels == clean(motif).pixels);
}

TEST_CASE("a half without samples leaves a picture as it is") {
  HalfPictures noisy = with_noise(wall, 0.1f);
  for (float& weight : noisy.second_weight.values) weight = 0;
  noisy.halves[1] = noisy.halves[0];
  CHECK(denoised(noisy).pixels == mean_picture(noisy).pixels);
}

TEST_CASE("denoised pictures have the same bits with any number of threads") {
  const HalfPictures noisy = with_noise(shadow, 0.3f);
  Image one, seven;
  with_threads(1, [&] { one = denoised(noisy); });
  with_threads(7, [&] { seven = denoised(noisy); });
  CHECK(one.pixels == seven.pixels);
}

TEST_CASE("a pixel that is far too bright is spread, and leaves no hole") {
  HalfPictures noisy = with_noise(wall, 0.05f);
  const std::size_t at = 20 * columns + 30;
  noisy.halves[0].color[0].values[at] += 200;
  const Image before = mean_picture(noisy), after = denoised(noisy);
  CHECK(after.pixels[at].r < 0.05f * before.pixels[at].r);
  for (const Rgb& pixel : after.pixels) CHECK(pixel.r > 0.3f);
}

TEST_CASE("a picture is denoised by albedo and normal, no other features") {
  HalfPictures noisy = with_noise(wall, 0.1f);
  noisy.halves[0].features.pop_back();
  CHECK_THROWS_WITH(denoised(noisy), "5 features: a picture is denoised by 6");
}

TEST_CASE("a filter that is to stop leaves out what it has not begun") {
  const HalfPictures noisy = with_noise(wall, 0.1f);
  const auto image_stopped_by = [&](bool is_stopped) {
    return picture_of(denoised_halves(noisy, [&] { return is_stopped; }), noisy.second_weight);
  };
  CHECK(image_stopped_by(false).pixels == denoised(noisy).pixels);
  CHECK(image_stopped_by(true).pixels != denoised(noisy).pixels);
}

}  // namespace twinray::test

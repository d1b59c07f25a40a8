// SPDX-License-Identifier: Apache-2.0
#include "integrators/half_films.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "integrators/denoise/denoise.h"
#include "integrators/denoise/filtered_error.h"
#include "integrators/path.h"
#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/film.h"
#include "tests/support/half_pictures.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

RenderOptions halved(std::uint32_t samples) {
  return {.width = 40,
          .height = 30,
          .samples = samples,
          .half_layers = std::vector{Layer::albedo, Layer::normal},
          .seed = 3};
}

const PathOptions three_bounces{.max_depth = 3};

/// The relative mean squared error that a picture of a room has against one of other samples.
double relative_error(const Image& picture, const Image& converged) {
  double sum = 0;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    for (float Rgb::*const c : {&Rgb::r, &Rgb::g, &Rgb::b}) {
      const double is = picture.pixels[i].*c, should = converged.pixels[i].*c;
      sum += std::pow(is - should, 2) / (should * should + 0.01);
    }
  return std::sqrt(sum / (3.0 * double(picture.pixels.size())));
}

/// By other samples than those of halved().
Image converged_picture(const Scene& scene, const Integrator& integrator, std::uint32_t samples) {
  RenderOptions options = halved(samples);
  options.half_layers.reset();
  options.seed = 77;
  return mean_image(render_with(scene, integrator, options).film);
}

/// A room with a second lamp, each in a group of its own.
Scene room_of_two_groups() {
  Scene scene = small_room();
  add_light(scene, PointLight{{0, 0.5f, 0}, {0.3f, 0.2f, 0.1f}, {}});
  scene.light_groups = {"lamp", "point"};
  scene.lights.back().group = 1;
  return scene;
}

}  // namespace

TEST_CASE("of each power of two of samples both halves have as many, and of others a third at least") {
  std::array<std::uint32_t, 2> counts{};
  for (std::uint32_t index = 0; index < 5000; ++index) {
    ++counts[half_of(index)];
    const std::uint32_t all = index + 1;
    if (all < 2) continue;
    CAPTURE(all);
    if ((all & (all - 1)) == 0) CHECK(counts[0] == counts[1]);
    CHECK(3 * std::min(counts[0], counts[1]) >= all);
  }
}

TEST_CASE("a half has aligned blocks of samples, which grow with their number") {
  for (std::uint32_t block = 1; block < 1u << 20; block *= 2)
    for (std::uint32_t i = 0; i < block; i += std::max(1u, block / 16)) {
      CHECK(half_of(2 * block + i) == 0);
      CHECK(half_of(3 * block + i) == 1);
    }
}

TEST_CASE("both halves together are the film") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, three_bounces);
  const RenderResult result = render_with(scene, path, halved(6));
  REQUIRE(result.halves);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) {
      PixelSums both = result.halves->first.pixel(x, y);
      both += result.halves->second.pixel(x, y);
      CHECK(both == result.film.pixel(x, y));
      CHECK(result.halves->first.pixel(x, y).count == 4);  // Samples 0, 2, 4 and 5.
    }
}

TEST_CASE("halves know the layers that they are asked for, whichever the film has") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, three_bounces);
  RenderOptions layered = halved(4);
  layered.layers = {Layer::depth, Layer::normal};
  const RenderResult halves = render_with(scene, path, layered);
  layered.layers = {Layer::albedo, Layer::normal};
  const RenderResult whole = render_with(scene, path, layered);
  const HalfPictures pictures = half_pictures(*halves.halves);
  REQUIRE(pictures.halves[0].features.size() == 6);
  double most = 0;
  for (std::size_t layer = 0; layer < 2; ++layer)
    for (int y = 0; y < 30; ++y)
      for (int x = 0; x < 40; ++x) {
        const std::size_t at = std::size_t(y) * 40 + std::size_t(x);
        const float mean = 0.5f * (pictures.halves[0].features[3 * layer].values[at] +
                                   pictures.halves[1].features[3 * layer].values[at]);
        most = std::max(most, std::fabs(double(mean) - whole.film.value(layer, x, y).r));
      }
  constexpr double rounding = 1e-6;  // Of floats below 1.
  CHECK(most < rounding);
  CHECK(same_bits(
      halves.film,
      render_with(
          scene, path,
          {.width = 40, .height = 30, .samples = 4, .layers = {Layer::depth, Layer::normal}, .seed = 3})
          .film));
}

TEST_CASE("the halves of independent noise tell its size, in whatever shares they have the samples") {
  for (const float weight : {0.5f, 0.25f}) {
    const Plane empty(128, 128);
    HalfPictures noisy{128, 128, {}, empty};
    for (HalfPicture& half : noisy.halves) half.color = {empty, empty, empty};
    Random random(5);
    constexpr float deviation = 0.2f;  // Of one sample; a picture has four.
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < empty.values.size(); ++i) {
        const auto half = [&](float samples) {
          return 3 + deviation / std::sqrt(samples) * std::sqrt(3.0f) * random.uniform(-1, 1);
        };
        noisy.halves[0].color[c].values[i] = half(4 * (1 - weight));
        noisy.halves[1].color[c].values[i] = half(4 * weight);
        noisy.second_weight.values[i] = weight;
      }
    const double expected = deviation / std::sqrt(4.0) / std::sqrt(9.01);
    CHECK(estimated_relative_error(noisy) ==
          Approx(expected).epsilon(0.02));  // 49,152 numbers: 3 deviations.
  }
}

TEST_CASE("the error that halves tell of a room is the one that it has") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, three_bounces);
  const Image reference = converged_picture(scene, path, 2048);
  for (const std::uint32_t samples : {16u, 64u}) {
    const RenderResult result = render_with(scene, path, halved(samples));
    const double is = relative_error(mean_image(result.film), reference);
    const double estimated = estimated_relative_error(half_pictures(*result.halves));
    CAPTURE(samples, is, estimated);
    // Stratified halves differ by more than the noise of both together: docs/denoising.md.
    CHECK(estimated > 0.9 * is);
    CHECK(estimated < 1.7 * is);
  }
}

TEST_CASE("halves with independent noise tell how far a filter without noise is from their mean") {
  constexpr int side = 96;
  const Plane empty(side, side);
  HalfPictures noisy{side, side, {}, empty};
  FilteredHalves filtered;
  Random random(9);
  constexpr float mean = 1, bias = 0.1f;
  for (std::size_t half = 0; half < 2; ++half)
    for (std::size_t c = 0; c < 3; ++c) {
      Plane &noise = noisy.halves[half].color[c] = empty, &constant = filtered[half][c] = empty;
      for (float& value : noise.values) value = mean + random.uniform(-0.2f, 0.2f);
      std::fill(constant.values.begin(), constant.values.end(), mean + bias);
    }
  std::fill(noisy.second_weight.values.begin(), noisy.second_weight.values.end(), 0.5f);
  const double expected = bias / std::sqrt(double(mean + bias) * (mean + bias) + 0.01);
  CHECK(estimated_relative_error(noisy, filtered) == Approx(expected).epsilon(0.03));
}

TEST_CASE("the error that halves tell of a denoised room is about the one that it has") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, three_bounces);
  const Image reference = converged_picture(scene, path, 4096);
  for (const std::uint32_t samples : {16u, 64u, 256u}) {
    const HalfPictures noisy = half_pictures(*render_with(scene, path, halved(samples)).halves);
    const double is = relative_error(denoised(noisy), reference);
    const double estimated = estimated_relative_error(noisy, denoised_halves(noisy));
    CAPTURE(samples, is, estimated);
    CHECK(estimated > 0.5 * is);
    CHECK(estimated < 2 * is);
    CHECK(estimated < 0.8 * estimated_relative_error(noisy));
  }
}

TEST_CASE("halves by light groups have each group's light, with the features of all") {
  const Scene scene = room_of_two_groups();
  const PathIntegrator path(scene, three_bounces);
  RenderOptions grouped = halved(8);
  grouped.light_groups = grouped.half_light_groups = true;
  const RenderResult result = render_with(scene, path, grouped);
  HalfPictures pictures = half_pictures(*result.halves);
  const std::vector<Plane> features = pictures.halves[1].features;
  for (std::size_t group = 0; group < 2; ++group) {
    take_light_group(*result.halves, group, pictures);
    const Image mean =
        image_of(means_of_halves(pictures.halves[0].color, pictures.halves[1].color, pictures.second_weight));
    double most = 0;
    for (int y = 0; y < mean.height; ++y)
      for (int x = 0; x < mean.width; ++x)
        most = std::max(most, std::fabs(double(mean.at(x, y).g) -
                                        parts_at(result.film, Division::groups, x, y)[group].g));
    constexpr double rounding = 1e-6;
    CHECK(most < rounding);
  }
  for (std::size_t i = 0; i < features.size(); ++i)
    CHECK(pictures.halves[1].features[i].values == features[i].values);
  grouped.light_groups = false;
  CHECK_THROWS_WITH(render_with(scene, path, grouped),
                    "halves by light groups need halves, and a film by light groups");
}

TEST_CASE("an error that takes long to estimate is asked for after a quarter more samples each time") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, three_bounces);
  RenderOptions targeted = halved(4096);
  targeted.noise_target = 1;
  std::vector<std::uint32_t> asked;
  targeted.estimated_error = [&](const HalfFilms& halves) {
    asked.push_back(halves.first.pixel(3, 4).count + halves.second.pixel(3, 4).count);
    return asked.size() < 6 ? 1.5 : 1.0;
  };
  const RenderResult result = render_with(scene, path, targeted);
  CHECK(asked == std::vector<std::uint32_t>{16, 32, 48, 64, 80, 112});
  CHECK(result.samples == 112);
  CHECK(result.error == 1.0);
}

TEST_CASE("a render with a noise target ends after the first pass that reaches it") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, three_bounces);
  const auto error_of = [&](std::uint32_t samples) {
    return estimated_relative_error(half_pictures(*render_with(scene, path, halved(samples)).halves));
  };
  RenderOptions targeted = halved(4096);
  targeted.half_layers = std::vector<Layer>{};
  targeted.noise_target = 0.5 * (error_of(48) + error_of(64));
  const RenderResult result = render_with(scene, path, targeted);
  CHECK(result.samples == 64);
  CHECK(result.is_complete);
  CHECK(result.error == error_of(64));
  std::optional<double> told;
  const auto accelerator = build_accelerator(default_backend(), scene.geometry);
  render(scene, *accelerator, path, targeted, [&](const RenderProgress& progress) { told = progress.error; });
  CHECK(told == result.error);
  CHECK(same_bits(result.film, render_with(scene, path, halved(64)).film));
  targeted.noise_target = 1e6;  // Chance is given no credit.
  CHECK(render_with(scene, path, targeted).samples == 16);
  targeted.samples = 4;
  CHECK(render_with(scene, path, targeted).samples == 4);
}

TEST_CASE("noise targets out of range are refused") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, three_bounces);
  RenderOptions targeted = halved(4);
  targeted.noise_target = 0;
  CHECK_THROWS_WITH(render_with(scene, path, targeted),
                    "a noise target of 0; it must be finite and more than 0");
  targeted.noise_target = 1;
  targeted.half_layers.reset();
  CHECK_THROWS_WITH(render_with(scene, path, targeted), "a noise target needs the halves of the samples");
}

}  // namespace twinray::test

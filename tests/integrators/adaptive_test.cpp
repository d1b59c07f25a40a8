// SPDX-License-Identifier: Apache-2.0
#include "integrators/adaptive.h"

#include <cmath>
#include <functional>

#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

constexpr std::uint32_t most = 1024;
/// What a rule may change of a picture's mean.
constexpr double most_loss = 0.003;

/// Of many pixels with independent samples of one distribution: the mean with a rule, over that of all
/// samples. Both have the samples that the rule takes in common, so that the ratio is far more exact than the
/// means.
struct Kept {
  double ratio;
  double standard_error;  ///< Of the ratio; over pixels.
  double samples;         ///< Share of all samples that the rule takes.
};

Kept kept(const AdaptiveSampling& adaptive, const std::function<float(Random&)>& draw) {
  constexpr int pixels = 2000;
  Random random(71);
  double stopped = 0, all = 0, squares = 0, taken = 0;
  for (int i = 0; i < pixels; ++i) {
    Film film(1, 1, {0, 0, 1, 1});
    double with_rule = -1;
    for (std::uint32_t index = 0; index < most; ++index) {
      const PixelSums& pixel = film.pixel(0, 0);
      if (with_rule < 0 && index > 0 && index % adaptive.batch == 0 && has_enough_samples(pixel, adaptive)) {
        with_rule = pixel.luminance_mean();
        taken += index;
      }
      const float value = draw(random);
      film.add(0, 0, index, {value, value, value});
    }
    const double mean = film.pixel(0, 0).luminance_mean();
    if (with_rule < 0) {
      with_rule = mean;
      taken += most;
    }
    stopped += with_rule;
    all += mean;
    squares += (with_rule - mean) * (with_rule - mean);
  }
  return {stopped / all, std::sqrt(squares) / all, taken / (double(pixels) * most)};
}

/// A constant, and now and then a bright sample.
std::function<float(Random&)> with_rare(float constant, float chance, float bright) {
  return [=](Random& random) { return constant + (random.unit() < chance ? bright : 0.0f); };
}

constexpr AdaptiveSampling careful{32, 0.05, AdaptiveRule::careful};
constexpr AdaptiveSampling cs184{32, 0.05, AdaptiveRule::cs184};

/// The mean luminance of the room with a rule, over that of all samples.
double kept_of_room(const PathOptions& path, const AdaptiveSampling& adaptive) {
  const Scene scene = small_room();
  const PathIntegrator integrator(scene, path);
  RenderOptions options{.width = 32, .height = 24, .samples = most, .seed = 5, .threads = 2};
  const double all = estimate_of(render_with(scene, integrator, options).film).mean;
  options.adaptive = adaptive;
  return estimate_of(render_with(scene, integrator, options).film).mean / all;
}

}  // namespace

TEST_CASE("adaptive sampling keeps the mean of samples of many distributions") {
  const std::function<float(Random&)> uniform = [](Random& random) { return 2 * random.unit(); };
  const std::function<float(Random&)> exponential = [](Random& random) {
    return float(-std::log(1 - double(random.unit())));
  };
  // The standard error of each ratio lies below 0.0004, so that a loss of 0.0042 is seen at 3 of them.
  for (const auto& draw :
       {uniform, exponential, with_rare(1, 0, 0), with_rare(0.5f, 0.5f, 1), with_rare(0, 0.002f, 500),
        with_rare(0, 0.02f, 50), with_rare(0.5f, 0.05f, 10), with_rare(0.9f, 0.04f, 2.5f)}) {
    const Kept found = kept(careful, draw);
    CAPTURE(found.ratio, found.standard_error, found.samples);
    CHECK(found.standard_error < 0.0004);
    CHECK(std::fabs(found.ratio - 1) < most_loss);
  }
}

TEST_CASE("calm pixels stop early, noisy and black ones do not") {
  CHECK(kept(careful, with_rare(1, 0, 0)).samples < 0.2);
  CHECK(kept(careful, with_rare(0.9f, 0.5f, 0.2f)).samples < 0.2);
  CHECK(kept(careful, with_rare(0, 0.02f, 50)).samples == 1);
  CHECK(kept(careful, with_rare(0, 0, 0)).samples == 1);
}

TEST_CASE("the rule of cs184 ends pixels that are black so far, and loses what light they would get") {
  // A light that one sample of fifty sees: half of the pixels have seen none of it after a batch.
  const Kept found = kept(cs184, with_rare(0, 0.02f, 50));
  CHECK(found.ratio < 0.6);
  CHECK(kept(cs184, with_rare(0, 0, 0)).samples == 32.0 / most);
}

TEST_CASE("pictures keep their mean, by lights and by directions") {
  for (const int depth : {1, 4}) {
    CAPTURE(depth);
    CHECK(std::fabs(kept_of_room({.max_depth = depth}, careful) - 1) < most_loss);
    const PathOptions directions{.max_depth = depth, .direct = DirectMethod::hemisphere};
    CHECK(std::fabs(kept_of_room(directions, careful) - 1) < most_loss);
    if (depth == 1) CHECK(kept_of_room(directions, cs184) < 0.95);
  }
}

TEST_CASE("pixels beside the scene stop after a batch, unless there is an environment") {
  Scene scene = small_room();
  scene.camera = view_whole(scene.camera, scene.geometry->bounds());
  scene.camera.tan_half_width *= 2;
  const RenderOptions options{.width = 32, .height = 12, .samples = 96, .adaptive = AdaptiveSampling{32, 0}};
  const auto count = [&] {
    const PathIntegrator integrator(scene, {.max_depth = 1});
    return render_with(scene, integrator, options).film.pixel(0, 6).count;
  };
  CHECK(count() == 32);
  Image black(1, 1);
  scene.lights.push_back({"sky", EnvironmentLight{std::make_shared<Image>(black)}});
  CHECK(count() == 96);
}

TEST_CASE("one sample is never enough") {
  Film film(1, 1, {0, 0, 1, 1});
  for (const AdaptiveRule rule : {AdaptiveRule::careful, AdaptiveRule::cs184})
    CHECK_FALSE(has_enough_samples(film.pixel(0, 0), {2, 1e6, rule}));
  film.add(0, 0, 0, {1, 1, 1});
  for (const AdaptiveRule rule : {AdaptiveRule::careful, AdaptiveRule::cs184})
    CHECK_FALSE(has_enough_samples(film.pixel(0, 0), {2, 1e6, rule}));
}

TEST_CASE("a pixel beside the scene goes on where its filter reaches the scene") {
  Scene scene = small_room();
  scene.camera = view_whole(scene.camera, scene.geometry->bounds());
  scene.camera.tan_half_width *= 2;
  const PathIntegrator integrator(scene, {.max_depth = 1});
  RenderOptions options{.width = 32, .height = 12, .samples = 96, .adaptive = AdaptiveSampling{32, 0}};
  const auto samples = [&](int x) { return render_with(scene, integrator, options).film.pixel(x, 6).count; };
  CHECK(samples(4) == 32);
  options.filter = filter_of_radius(FilterKind::triangle, 8);
  CHECK(samples(4) == 96);
  options.filter = filter_of_radius(FilterKind::triangle, 1);
  CHECK(samples(4) == 32);
}

}  // namespace twinray::test

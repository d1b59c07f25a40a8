// SPDX-License-Identifier: Apache-2.0
#include "integrators/path.h"

#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

RenderOptions path_options(std::uint32_t samples, SamplerKind sampler = SamplerKind::independent) {
  return {.width = 12, .height = 10, .samples = samples, .sampler = sampler, .seed = 3, .threads = 2};
}

Rgb pixel_mean(const Film& film, int x, int y) { return film.pixel(x, y).mean(); }

}  // namespace

TEST_CASE("at equal seed no greater depth takes light away from any pixel") {
  const Scene scene = small_room();
  RenderResult before = render_with(scene, PathIntegrator(scene, {.max_depth = 0}), path_options(4));
  for (int depth = 1; depth <= 6; ++depth) {
    const RenderResult after =
        render_with(scene, PathIntegrator(scene, {.max_depth = depth}), path_options(4));
    for (int y = 0; y < 10; ++y)
      for (int x = 0; x < 12; ++x) {
        CHECK(pixel_mean(after.film, x, y).r >= pixel_mean(before.film, x, y).r);
        CHECK(pixel_mean(after.film, x, y).b >= pixel_mean(before.film, x, y).b);
      }
    before = after;
  }
}

TEST_CASE("the mean does not depend on roulette, sampler or samples per light") {
  const Scene scene = small_room();
  const Estimate without = estimate(scene, {.max_depth = 8, .roulette = {1}}, path_options(256));
  const auto check = [&](const PathOptions& path, const RenderOptions& how) {
    check_same_mean(estimate(scene, path, how), without, 0.035);
  };
  check({.max_depth = 8}, path_options(256));
  check({.max_depth = 8, .roulette = {0.7f}}, path_options(256));
  check({.max_depth = 8, .roulette = {0.4f}}, path_options(256));
  check({.max_depth = 8, .roulette = {1}}, path_options(256, SamplerKind::sobol));
  check({.max_depth = 8, .samples_per_light = 4, .roulette = {1}}, path_options(128));
}

TEST_CASE("no path of the default ends at random before its fourth bounce, and those of a fixed chance may") {
  // A closed box: each of the first bounces is made unless roulette ends the path. The ray of the last one is
  // not traced, light sampling has counted what it would find.
  const Scene scene = emissive_enclosure(1, 0.5f);
  const auto bounces = [&](int depth, Roulette roulette) {
    const PathOptions path{.max_depth = depth, .direct = DirectMethod::lights, .roulette = roulette};
    const RenderResult result = render_with(scene, PathIntegrator(scene, path), path_options(64));
    return double(result.rays.bounce) / double(result.rays.camera);
  };
  constexpr double tolerance = 0.012;  // Four standard errors of 7680 paths; 0 where nothing is random.
  CHECK(bounces(4, {}) == 3);
  CHECK(bounces(5, {1}) == 4);
  CHECK(bounces(5, {}) == Approx(3 + 0.25).margin(2 * tolerance));  // By the root of a throughput of 0.5^4.
  CHECK(bounces(3, {0.25f}) == Approx(1 + 0.25).margin(2 * tolerance));
}

TEST_CASE("hemisphere and light sampling have the same mean where no light is a delta") {
  const Scene scene = small_room();
  const Estimate by_lights = estimate(scene, {.max_depth = 3}, path_options(256));
  const Estimate by_directions = estimate(
      scene, {.max_depth = 3, .direct = DirectMethod::hemisphere, .samples_per_light = 8}, path_options(512));
  check_same_mean(by_directions, by_lights, 0.065);
}

TEST_CASE("direct and indirect light add up to all of it, and the last bounces to the whole as well") {
  const Scene scene = small_room();
  const auto mean_of = [&](int first, int last) {
    const PathOptions path{.max_depth = 4, .first_depth = first, .last_depth = last, .roulette = {0.7f}};
    return render_with(scene, PathIntegrator(scene, path), path_options(16)).film;
  };
  const Film all = mean_of(0, 100), direct = mean_of(0, 1), indirect = mean_of(2, 100);
  const Film bounce[5] = {mean_of(0, 0), mean_of(1, 1), mean_of(2, 2), mean_of(3, 3), mean_of(4, 4)};
  // A sum of a few floats in another order.
  for (int y = 0; y < 10; ++y)
    for (int x = 0; x < 12; ++x) {
      const double whole = pixel_mean(all, x, y).g;
      CHECK(pixel_mean(direct, x, y).g + pixel_mean(indirect, x, y).g ==
            Approx(whole).epsilon(render_rounding));
      double sum = 0;
      for (const Film& film : bounce) sum += pixel_mean(film, x, y).g;
      CHECK(sum == Approx(whole).epsilon(render_rounding));
    }
}

TEST_CASE("samples estimated together have the bits of each alone, and as many rays") {
  Scene scene = small_room();
  add_light(scene, PointLight{{0.3f, 0.2f, 0.1f}, {1, 2, 3}, {}});
  const auto accelerator = build_accelerator(Backend::bvh, scene.geometry);
  const Camera camera = fit_frame(scene.camera, 4, 3);
  std::vector<CameraSample> samples;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const Vec2 frame{float(i % 50) / 50, float(i / 50) / 40};
    samples.push_back({camera_ray(camera, frame, {}), {7, i % 50, i / 50, i % 3}});
  }
  const PathOptions cases[] = {{},
                               {.max_depth = 3, .samples_per_light = 5},
                               {.max_depth = 4, .first_depth = 2, .last_depth = 3},
                               {.max_depth = 2, .direct = DirectMethod::hemisphere, .samples_per_light = 2}};
  for (const PathOptions& path_options : cases) {
    const PathIntegrator path(scene, path_options);
    Tracer alone(*accelerator, true), together(*accelerator, true);
    std::vector<Rgb> estimates(samples.size());
    path.sample(samples, SamplerKind::sobol, together, RecordSpans(estimates));
    for (std::size_t i = 0; i < samples.size(); ++i)
      CHECK(path.radiance(samples[i].ray, SamplerKind::sobol, samples[i].key, alone) == estimates[i]);
    CHECK(alone.counts() == together.counts());
  }
}

TEST_CASE("options out of range are refused") {
  const Scene scene = small_room();
  const auto message_of = [&](const PathOptions& path) -> std::string {
    try {
      PathIntegrator(scene, path);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "accepted";
  };
  CHECK(message_of({.max_depth = 101}) == "the maximum depth is 101; it must lie in [0, 100]");
  CHECK(message_of({.max_depth = -1}) == "the maximum depth is -1; it must lie in [0, 100]");
  CHECK(message_of({.samples_per_light = 0}) == "0 samples per light; valid are 1 to 65536");
  CHECK(message_of({.roulette = {1.5f}}) == "the probability of going on is 1.5; it must lie in (0, 1]");
  CHECK(message_of({}) == "accepted");
}

}  // namespace twinray::test

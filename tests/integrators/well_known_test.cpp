// SPDX-License-Identifier: Apache-2.0
// What CS184's five parts ask of a path tracer, on CS184's own scenes.

#include <algorithm>
#include <array>
#include <cmath>

#include "check/difference.h"
#include "integrators/normals.h"
#include "io/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/statistics.h"

namespace twinray::test {
namespace {

struct KnownScene {
  const char* file;
  bool only_delta_lights;  ///< A point or a direction: hemisphere sampling finds none of its light.
};

constexpr KnownScene cs184[] = {{"keenan/banana.dae", false},
                                {"meshedit/cow.dae", true},
                                {"meshedit/maxplanck.dae", true},
                                {"meshedit/teapot.dae", true},
                                {"simple/cube.dae", true},
                                {"simple/plane.dae", true},
                                {"sky/bunny.dae", false},
                                {"sky/CBbunny.dae", false},
                                {"sky/CBcoil.dae", false},
                                {"sky/CBdragon.dae", false},
                                {"sky/CBempty.dae", false},
                                {"sky/CBgems.dae", false},
                                {"sky/CBlucy.dae", false},
                                {"sky/CBspheres.dae", false},
                                {"sky/CBspheres_lambertian.dae", false},
                                {"sky/CBspheres_microfacet_al_ag.dae", false}};

Scene load(const std::string& file) {
  return load_scene(std::string(TWINRAY_SCENES) + "/cs184/" + file).scene;
}

/// With the camera where it sees all of the scene: the cameras of CS184's boxes stand at floor level.
Scene load_whole(const std::string& file, const RenderOptions& options) {
  Scene scene = load(file);
  scene.camera = view_whole(fit_frame(scene.camera, options.width, options.height), scene.geometry->bounds());
  return scene;
}

RenderOptions frame(int width, int height, std::uint32_t samples, std::uint64_t seed = 1) {
  return {.width = width, .height = height, .samples = samples, .seed = seed, .threads = 2};
}

RenderResult render_built(const Scene& scene, const Accelerator& accelerator, RenderOptions options,
                          int threads) {
  options.threads = threads;
  return render(scene, accelerator, PathIntegrator(scene, {}), options);
}

/// The middle of the frame, as much as brute force can render with 3e7 primitive tests or so.
PixelRect affordable_middle(const Scene& scene, const RenderOptions& options) {
  constexpr double tests = 3e7, rays_per_sample = 10;
  const double tests_per_pixel =
      rays_per_sample * options.samples * double(scene.geometry->primitive_count());
  const double share = tests / tests_per_pixel / (options.width * options.height);
  const double side = std::sqrt(std::min(1.0, share));
  const int width = std::max(1, int(side * options.width)), height = std::max(1, int(side * options.height));
  const int x = (options.width - width) / 2, y = (options.height - height) / 2;
  return {x, y, x + width, y + height};
}

double primitives_per_ray(const Scene& scene, BvhSplit split, const RenderOptions& options) {
  const auto accelerator =
      build_accelerator(Backend::bvh, scene.geometry, {.bvh_width = 2, .bvh_split = split});
  const RayCounts rays = render(scene, *accelerator, PathIntegrator(scene, {}), options).rays;
  return double(rays.queries.primitives) / double(rays.total());
}

/// Luminance of a block of pixels: the mean of its pixels' means, and its standard error.
Estimate block_estimate(const Film& film, const PixelRect& block) {
  double sum = 0, variance = 0;
  for (int y = block.y0; y < block.y1; ++y)
    for (int x = block.x0; x < block.x1; ++x) {
      const PixelSums& pixel = film.pixel(x, y);
      sum += pixel.luminance_mean();
      variance += pixel.luminance_variance() / pixel.count;
    }
  const double pixels = double(block.width()) * block.height();
  return {sum / pixels, std::sqrt(variance) / pixels};
}

}  // namespace

TEST_CASE("brute force, BVH and embree give the same bits on every scene of cs184 with 1, 2 and 7 threads") {
  for (const KnownScene& known : cs184) {
    const RenderOptions options = frame(48, 36, 1);
    const Scene scene = load_whole(known.file, options);
    RenderOptions middle = options;
    middle.window = affordable_middle(scene, options);
    const auto oracle = build_accelerator(Backend::brute_force, scene.geometry);
    const RenderResult exact = render_built(scene, *oracle, middle, 1);
    std::optional<RenderResult> first;
    for (const Backend backend : available_backends()) {
      if (backend == Backend::brute_force || backend == Backend::embree_native) continue;
      const auto accelerator = build_accelerator(backend, scene.geometry);
      INFO(known.file << ", " << backend_name(backend));
      CHECK(render_built(scene, *accelerator, middle, 1).rays == exact.rays);
      for (const int threads : {1, 2, 7}) {
        INFO(threads << " threads");
        RenderResult found = render_built(scene, *accelerator, options, threads);
        CHECK(first_difference(found.film, exact.film).value_or("none") == "none");
        if (!first) {
          first = std::move(found);
          continue;
        }
        CHECK(first_difference(first->film, found.film).value_or("none") == "none");
        CHECK(first->rays == found.rays);
      }
    }
    for (const int threads : {2, 7})
      CHECK(same_bits(render_built(scene, *oracle, middle, threads).film, exact.film));
  }
}

TEST_CASE("normal shading of the cow by brute force tests 5,856 triangles for each pixel's one ray") {
  const Scene scene = load("meshedit/cow.dae");
  const auto oracle = build_accelerator(Backend::brute_force, scene.geometry);
  for (const auto& [width, height] : {std::pair{48, 36}, {33, 7}}) {
    RenderOptions options = frame(width, height, 1);
    options.counting = true;
    const RenderResult result = render(scene, *oracle, NormalsIntegrator(scene), options);
    const std::uint64_t pixels = std::uint64_t(width) * std::uint64_t(height);
    CHECK(result.rays.camera == pixels);
    CHECK(result.rays.total() == pixels);
    CHECK(result.rays.queries.primitives == 5856 * pixels);
  }
}

TEST_CASE("the surface area heuristic needs fewer primitive tests a ray than median, midpoint and mean") {
  for (const char* file : {"meshedit/cow.dae", "sky/bunny.dae", "sky/CBbunny.dae", "sky/CBlucy.dae"}) {
    RenderOptions options = frame(64, 48, 2);
    options.counting = true;
    const Scene scene = load_whole(file, options);
    const double sah = primitives_per_ray(scene, BvhSplit::sah, options);
    for (const BvhSplit other : {BvhSplit::median, BvhSplit::midpoint, BvhSplit::mean}) {
      const double tests = primitives_per_ray(scene, other, options);
      INFO(file << ": sah " << sah << ", split " << int(other) << ": " << tests);
      CHECK(sah < tests);
    }
  }
}

TEST_CASE("the mean of CBbunny depends on no sampler, engine, number of threads or roulette") {
  struct Way {
    SamplerKind sampler;
    Backend backend;
    int threads;
    float continuation;
    std::uint32_t samples;
  };
  const Way ways[] = {{SamplerKind::independent, Backend::bvh, 1, 0, 256},
                      {SamplerKind::independent, default_backend(), 2, 0.65f, 256},
                      {SamplerKind::independent, Backend::bvh, 7, 1, 256},
                      {SamplerKind::sobol, default_backend(), 2, 0, 256},
                      {SamplerKind::sobol, Backend::bvh, 1, 0.65f, 256}};
  std::vector<Estimate> estimates;
  for (const Way& way : ways) {
    RenderOptions options = frame(16, 12, way.samples, estimates.size());
    options.sampler = way.sampler;
    options.threads = way.threads;
    const Scene scene = load_whole("sky/CBbunny.dae", options);
    estimates.push_back(estimate(scene, {.roulette = {way.continuation}}, options, way.backend));
    INFO("way " << estimates.size());
    CHECK(estimates.back().mean > 0);
    if (estimates.size() > 1) check_same_mean(estimates.back(), estimates.front(), 0.3);
  }
}

TEST_CASE("hemisphere and light sampling converge to the same image") {
  constexpr int block = 4, width = 24, height = 16, blocks = (width / block) * (height / block);
  for (const int depth : {1, 3}) {
    RenderOptions options = frame(width, height, 512, 11);
    options.sampler = SamplerKind::independent;
    const Scene scene = load_whole("sky/CBspheres_lambertian.dae", options);
    const PathOptions by_lights{.max_depth = depth};
    const PathOptions by_hemisphere{.max_depth = depth, .direct = DirectMethod::hemisphere};
    const Film lights = render_with(scene, PathIntegrator(scene, by_lights), options).film;
    options.seed = 12;
    const Film hemisphere = render_with(scene, PathIntegrator(scene, by_hemisphere), options).film;
    for (int y = 0; y < height; y += block)
      for (int x = 0; x < width; x += block) {
        const PixelRect rect{x, y, x + block, y + block};
        const Estimate a = block_estimate(lights, rect), b = block_estimate(hemisphere, rect);
        INFO("depth " << depth << ", block at " << x << " " << y << ": " << a.mean << " +- "
                      << a.standard_error << ", " << b.mean << " +- " << b.standard_error);
        CHECK(z_test(a.mean - b.mean, std::hypot(a.standard_error, b.standard_error), 0) >=
              sidak_level(2 * blocks));
      }
  }
}

TEST_CASE("adaptive sampling by the careful rule keeps the mean of all samples") {
  // The same samples but for those left out: the difference is the rule's alone, and 0.003 of the mean is
  // seen.
  constexpr double most_loss = 0.003;
  for (const char* name : {"sky/CBspheres_lambertian.dae", "sky/CBempty.dae"})
    for (const DirectMethod direct : {DirectMethod::lights, DirectMethod::hemisphere}) {
      RenderOptions options = frame(32, 24, 1024);
      const Scene scene = load_whole(name, options);
      const PathIntegrator path(scene, {.max_depth = 1, .direct = direct});
      const double all = estimate_of(render_with(scene, path, options).film).mean;
      options.adaptive = AdaptiveSampling{32, 0.05};
      const double careful = estimate_of(render_with(scene, path, options).film).mean;
      INFO(name << ": " << careful << " instead of " << all);
      CHECK(std::fabs(careful - all) <= most_loss * all);
    }
}

TEST_CASE(
    "adaptive sampling by the rule of cs184 keeps its tolerance on nine pixels of ten, with fewer samples") {
  // About half of the samples are saved at this tolerance.
  constexpr double tolerance = 0.05, mean_tolerance = 0.01, most_samples = 0.6;
  RenderOptions options = frame(32, 24, 2048);
  const Scene scene = load_whole("sky/CBbunny.dae", options);
  options.adaptive = AdaptiveSampling{32, tolerance, AdaptiveRule::cs184};
  const Film adaptive = render_with(scene, PathIntegrator(scene, {}), options).film;
  const RenderOptions converged_options = frame(32, 24, 4096, 99);
  const Film converged = render_with(scene, PathIntegrator(scene, {}), converged_options).film;
  int good = 0, pixels = 0;
  double samples = 0;
  for (int y = 0; y < options.height; ++y)
    for (int x = 0; x < options.width; ++x) {
      const double expected = converged.pixel(x, y).luminance_mean();
      const double found = adaptive.pixel(x, y).luminance_mean();
      good += std::fabs(found - expected) <= tolerance * expected;
      samples += adaptive.pixel(x, y).count;
      ++pixels;
    }
  const Estimate a = estimate_of(adaptive), b = estimate_of(converged);
  INFO(good << " of " << pixels << " pixels within the tolerance, " << samples / pixels
            << " samples a pixel, means " << a.mean << " and " << b.mean);
  CHECK(good >= 0.9 * pixels);
  CHECK(std::fabs(a.mean - b.mean) <= mean_tolerance * b.mean);
  CHECK(samples <= most_samples * options.samples * pixels);
}

TEST_CASE("every integrator renders every scene of cs184 without rejected samples") {
  for (const KnownScene& known : cs184) {
    const RenderOptions options = frame(32, 24, 16);
    const Scene scene = load_whole(known.file, options);
    const auto accelerator = build_accelerator(default_backend(), scene.geometry);
    const auto mean_of = [&](const Integrator& integrator) {
      const Film film = render(scene, *accelerator, integrator, options).film;
      CHECK(film.rejected_count() == 0);
      return estimate_of(film).mean;
    };
    const PathOptions by_hemisphere{.max_depth = 1, .direct = DirectMethod::hemisphere};
    INFO(known.file);
    CHECK(mean_of(NormalsIntegrator(scene)) > 0);
    CHECK(mean_of(PathIntegrator(scene, {.max_depth = 1})) > 0);
    CHECK(mean_of(PathIntegrator(scene, {})) > 0);
    CHECK((mean_of(PathIntegrator(scene, by_hemisphere)) == 0) == known.only_delta_lights);
  }
}

}  // namespace twinray::test

// SPDX-License-Identifier: Apache-2.0
#include "integrators/render.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <mutex>

#include "check/recorded_rays.h"
#include "integrators/normals.h"
#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/flush_denormals.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

RenderOptions options(std::uint32_t samples, int threads) {
  return {.width = 40, .height = 30, .samples = samples, .seed = 11, .threads = threads};
}

std::vector<Backend> canonical_backends() {
  std::vector<Backend> backends;
  for (const Backend backend : available_backends())
    if (backend != Backend::embree_native) backends.push_back(backend);
  return backends;
}

/// A path integrator that spoils the samples of one pixel.
class SpoiledIntegrator final : public PlainIntegrator {
  Rgb radiance_of(const CameraSample& sample, SamplerKind, Tracer&) const override {
    const SampleKey& key = sample.key;
    if (key.x == 3 && key.y == 2 && key.index >= 1) return {NAN, 0, 0};
    return {1, 1, 1};
  }
};

}  // namespace

TEST_CASE("pictures and ray counts have the same bits on every engine and with 1, 2 and 7 threads") {
  const Scene scene = small_room();
  for (const SamplerKind sampler : {SamplerKind::sobol, SamplerKind::independent}) {
    const PathIntegrator path(scene, {.max_depth = 4});
    RenderOptions first = options(4, 1);
    first.sampler = sampler;
    const RenderResult reference = render_with(scene, path, first, Backend::brute_force);
    for (const Backend backend : canonical_backends())
      for (const int threads : {1, 2, 7}) {
        RenderOptions other = first;
        other.threads = threads;
        const RenderResult result = render_with(scene, path, other, backend);
        INFO(backend_name(backend) << " with " << threads << " threads");
        CHECK(same_bits(result.film, reference.film));
        CHECK(result.rays == reference.rays);
      }
  }
}

TEST_CASE("a caller that flushes denormal numbers gets the same picture") {
  // In a room of 10^-19 units, areas and cross products of edges are denormal.
  const Scene scene = small_room(1e-19f);
  const auto render_room = [&](Backend backend, int threads) {
    return render_with(scene, PathIntegrator(scene, {.max_depth = 3}), options(4, threads), backend).film;
  };
  const Film expected = render_room(Backend::brute_force, 1);
  CHECK(estimate_of(expected).mean > 0.1);
  const FlushDenormals flush;
  for (const Backend backend : canonical_backends())
    for (const int threads : {1, 3}) CHECK(same_bits(render_room(backend, threads), expected));
  CHECK(FlushDenormals::are_flushed());
}

TEST_CASE("observers get the rays of each sample, in the order of its path") {
  const Scene scene = small_room();
  const auto accelerator = build_accelerator(Backend::bvh, scene.geometry);
  const PathIntegrator path(scene, {.max_depth = 3});
  const Camera camera = fit_frame(scene.camera, 5, 4);
  RenderOptions observed{.width = 5, .height = 4, .samples = 1, .sampler = SamplerKind::independent};
  std::size_t samples = 0;
  observed.threads = 1;
  observed.observe = [&](const PixelSample& sample, std::span<const RecordedRay> rays) {
    const SampleKey key{0, std::uint32_t(sample.x), std::uint32_t(sample.y), 0};
    std::vector<RecordedRay> alone;
    record_sample(path, camera, *accelerator, {(float(sample.x) + 0.5f) / 5, (float(sample.y) + 0.5f) / 4},
                  key, alone);
    REQUIRE(rays.size() == alone.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      CHECK(rays[i].ray.origin == alone[i].ray.origin);
      CHECK(rays[i].ray.direction == alone[i].ray.direction);
      CHECK(rays[i].kind == alone[i].kind);
      CHECK(rays[i].vertex == alone[i].vertex);
    }
    ++samples;
  };
  render(scene, *accelerator, path, observed);
  CHECK(samples == 5 * 4);
}

TEST_CASE("a part of the frame has the pixels of the whole") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 3});
  const RenderResult whole = render_with(scene, path, options(4, 2));
  for (const PixelRect& window : {PixelRect{7, 5, 29, 22}, PixelRect{8, 5, 9, 22}, PixelRect{7, 6, 29, 7}}) {
    RenderOptions part_options = options(4, 2);
    part_options.window = window;
    const RenderResult part = render_with(scene, path, part_options);
    for (int y = window.y0; y < window.y1; ++y)
      for (int x = window.x0; x < window.x1; ++x) CHECK(part.film.pixel(x, y) == whole.film.pixel(x, y));
  }
}

TEST_CASE("normal shading traces one ray a sample and shows (n + 1) / 2") {
  const Scene scene = scene_of(floor_square(50, 0), {0.5f, 0.5f, 0.5f}, {0, 1, 0}, {0, 0, 0});
  const RenderResult result = render_with(scene, NormalsIntegrator(scene), options(1, 2));
  CHECK(result.rays.camera == 40 * 30);
  CHECK(result.rays.total() == 40 * 30);
  CHECK(result.film.pixel(20, 15).mean() == Rgb{0.5f, 1, 0.5f});
}

TEST_CASE("normals may be shown as they mix") {
  Mesh roof = floor_square(50, 0);
  roof.normals = {{0.6f, 0.8f, 0}, {-0.6f, 0.8f, 0}};
  roof.normal_indices.clear();
  for (const Triangle& triangle : roof.triangles) {
    Triangle& normals = roof.normal_indices.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) normals[i] = roof.positions[triangle[i]].x > 0;
  }
  const Scene scene = scene_of(roof, {0.5f, 0.5f, 0.5f}, {0, 1, 0}, {0, 0, 0});
  const auto shown = [&](NormalsIntegrator::Mixture mixture) {
    return render_with(scene, NormalsIntegrator(scene, mixture), {.width = 9, .height = 9, .samples = 1})
        .film.pixel(4, 4)
        .mean();
  };
  CHECK(shown(NormalsIntegrator::Mixture::unit).g == Approx(1).epsilon(1e-3));
  CHECK(shown(NormalsIntegrator::Mixture::as_it_is).g == Approx(0.9).epsilon(1e-3));
}

TEST_CASE("one sample goes through the centre of its pixel") {
  // A floor that covers exactly the right half of an odd-sized frame: the middle column's centre lies on its
  // edge.
  Scene scene = scene_of(floor_square(1, 0), {0.5f, 0.5f, 0.5f}, {0, 4, 0}, {0, 0, 0});
  const RenderResult result =
      render_with(scene, NormalsIntegrator(scene), {.width = 9, .height = 9, .samples = 1});
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 9; ++x) {
      const Camera& camera = scene.camera;
      const double px = ((2 * (x + 0.5) / 9) - 1) * camera.tan_half_width * 4;
      const double py = ((2 * (y + 0.5) / 9) - 1) * camera.tan_half_height * 4;
      const bool covered = std::fabs(px) < 1 && std::fabs(py) < 1;
      CHECK((result.film.pixel(x, y).mean().g > 0.9f) == covered);
    }
}

TEST_CASE("samples that are not finite are counted, and the first can be found again") {
  const Scene scene = small_room();
  const RenderResult result =
      render_with(scene, SpoiledIntegrator(), {.width = 8, .height = 8, .samples = 4});
  CHECK(result.film.rejected_count() == 3);
  CHECK(result.film.first_rejected().x == 3);
  CHECK(result.film.first_rejected().y == 2);
  CHECK(result.film.first_rejected().index == 1);
  CHECK(result.film.pixel(3, 2).count == 1);
}

TEST_CASE(
    "adaptive sampling stops at whole batches, sooner where the picture is calm, and rejected samples "
    "count") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 3});
  RenderOptions adaptive = options(256, 2);
  adaptive.adaptive = AdaptiveSampling{16, 0.1};
  const RenderResult result = render_with(scene, path, adaptive);
  std::uint64_t taken = 0;
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) {
      const std::uint32_t count = result.film.pixel(x, y).count;
      CHECK(count % 16 == 0);
      CHECK(count >= 16);
      taken += count;
    }
  CHECK(taken < 256 * 40 * 30);
  CHECK(taken == result.rays.camera);
  RenderOptions spoiled{
      .width = 8, .height = 8, .samples = 64, .adaptive = AdaptiveSampling{8, 0.1, AdaptiveRule::cs184}};
  const RenderResult calm = render_with(scene, SpoiledIntegrator(), spoiled);
  CHECK(calm.film.pixel(0, 0).count == 8);
  CHECK(calm.film.pixel(3, 2).count == 1);
}

TEST_CASE("a pixel that stops has the bits of its samples until then, and each decides for itself") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 1, .direct = DirectMethod::hemisphere});
  constexpr std::uint32_t batch = 24, most = 80;
  RenderOptions adaptive = options(most, 2);
  adaptive.adaptive = AdaptiveSampling{batch, 2};
  const Film film = render_with(scene, path, adaptive).film;
  std::uint32_t stops[4] = {};
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t count = std::min((i + 1) * batch, most);
    const Film fixed = render_with(scene, path, options(count, 2)).film;
    for (int y = 0; y < 30; ++y)
      for (int x = 0; x < 40; ++x) {
        if (film.pixel(x, y).count != count) continue;
        ++stops[i];
        CHECK(film.pixel(x, y) == fixed.pixel(x, y));
        if (count < most) CHECK(has_enough_samples(fixed.pixel(x, y), *adaptive.adaptive));
      }
  }
  CHECK(stops[0] + stops[1] + stops[2] + stops[3] == 40 * 30);
  CHECK(stops[0] > 0);
  CHECK(stops[1] + stops[2] > 0);
  CHECK(stops[3] > 0);
  adaptive.window = PixelRect{11, 7, 22, 20};
  const Film part = render_with(scene, path, adaptive).film;
  for (int y = 7; y < 20; ++y)
    for (int x = 11; x < 22; ++x) CHECK(part.pixel(x, y) == film.pixel(x, y));
}

TEST_CASE("adaptive pictures do not depend on threads either") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 2});
  RenderOptions one = options(96, 1);
  one.adaptive = AdaptiveSampling{8, 0.2};
  RenderOptions seven = one;
  seven.threads = 7;
  CHECK(same_bits(render_with(scene, path, one).film, render_with(scene, path, seven).film));
}

TEST_CASE("a render that is stopped has the samples that were done, and says that it is not complete") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 2});
  RenderOptions stopped = options(64, 2);
  std::atomic<int> asked = 0;
  stopped.is_stopped = [&] { return ++asked > 4000; };  // Of 1200 pixels, after some passes.
  const RenderResult result = render_with(scene, path, stopped);
  CHECK_FALSE(result.is_complete);
  const std::uint64_t samples = sample_count(result.film);
  CHECK(samples > 1200);
  CHECK(samples < 64 * 1200);
  // The samples of a pixel are the first of those that it would have had.
  const PixelSums& pixel = result.film.pixel(20, 15);
  REQUIRE(pixel.count > 1);
  CHECK(render_with(scene, path, options(pixel.count, 1)).film.pixel(20, 15) == pixel);
  stopped.is_stopped = [] { return false; };
  CHECK(render_with(scene, path, stopped).is_complete);
}

TEST_CASE("whoever watches passes sees all samples of each, more each time, and changes nothing") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 2});
  RenderOptions watched = options(9, 3);
  std::vector<std::uint64_t> samples;
  watched.pass_done = [&](const Film& film) { samples.push_back(sample_count(film)); };
  const RenderResult result = render_with(scene, path, watched, Backend::bvh);
  CHECK(samples == std::vector<std::uint64_t>{1200, 2 * 1200, 4 * 1200, 8 * 1200, 9 * 1200});
  CHECK(same_bits(result.film, render_with(scene, path, options(9, 1), Backend::bvh).film));
}

TEST_CASE("whoever watches tiles sees each once a pass with all of its samples, and changes nothing") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 2});
  RenderOptions watched = options(3, 3);
  std::mutex mutex;
  std::map<std::pair<int, int>, std::vector<std::uint32_t>> counts;
  watched.tile_done = [&](const Film& film, const PixelRect& tile) {
    const std::uint32_t count = film.pixel(tile.x0, tile.y0).count;
    for (int y = tile.y0; y < tile.y1; ++y)
      for (int x = tile.x0; x < tile.x1; ++x)
        if (film.pixel(x, y).count != count) return;
    const std::lock_guard lock(mutex);
    counts[{tile.x0, tile.y0}].push_back(count);
  };
  const RenderResult result = render_with(scene, path, watched, Backend::bvh);
  CHECK(counts.size() == 6);  // 40 x 30 pixels
  for (const auto& [place, of_passes] : counts) CHECK(of_passes == std::vector<std::uint32_t>{1, 2, 3});
  CHECK(same_bits(result.film, render_with(scene, path, options(3, 1), Backend::bvh).film));
}

TEST_CASE("a pass or a tile that is stopped is not shown as done") {
  const Scene scene = small_room();
  std::atomic<int> asked = 0;
  RenderOptions stopped = options(64, 1);
  stopped.is_stopped = [&] { return ++asked > 100; };
  bool is_shown = false;
  stopped.pass_done = [&](const Film&) { is_shown = true; };
  stopped.tile_done = [&](const Film&, const PixelRect&) { is_shown = true; };
  render_with(scene, PathIntegrator(scene, {.max_depth = 2}), stopped, Backend::bvh);
  CHECK_FALSE(is_shown);
}

TEST_CASE("a render whose time is over has whole passes, those of a render of as many samples") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 2});
  RenderOptions timed = options(Film::max_samples, 2);
  for (const double seconds : {1e-9, 0.2}) {
    timed.seconds = seconds;
    const RenderResult result = render_with(scene, path, timed);
    CAPTURE(seconds, result.samples);
    CHECK(result.is_complete);
    REQUIRE(result.samples >= 1);
    CHECK(sample_count(result.film) == 1200 * std::uint64_t(result.samples));
    if (seconds < 1e-3) CHECK(result.samples == 1);
    // One sample alone goes through the pixel's centre.
    if (result.samples > 1)
      CHECK(same_bits(result.film, render_with(scene, path, options(result.samples, 1)).film));
  }
  RenderOptions sampled = options(5, 2);
  sampled.seconds = 1e6;
  const RenderResult result = render_with(scene, path, sampled);
  CHECK(result.is_complete);
  CHECK(result.samples == 5);
  CHECK(same_bits(result.film, render_with(scene, path, options(5, 1)).film));
}

TEST_CASE("a render of any time ends when all pixels have converged") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 2});
  RenderOptions timed = options(Film::max_samples, 2);
  timed.seconds = 10;
  timed.adaptive = AdaptiveSampling{8, 10};
  const RenderResult result = render_with(scene, path, timed);
  CHECK(result.is_complete);
  CHECK(result.samples >= 8);
  CHECK(result.samples < 64);
}

TEST_CASE("a render is complete only with all samples, wherever it is stopped") {
  const Scene scene = small_room();
  const NormalsIntegrator normals(scene);
  RenderOptions stopped = options(1, 1);
  constexpr int enough = 1300;  // It asks once a pixel, and some times a tile.
  int complete = 0;
  for (int most = 0; most < enough; most += 11) {
    CAPTURE(most);
    int asked = 0;
    stopped.is_stopped = [&] { return ++asked > most; };
    const RenderResult result = render_with(scene, normals, stopped);
    complete += result.is_complete;
    if (result.is_complete) CHECK(sample_count(result.film) == 1200);
  }
  CHECK(complete > 0);
  CHECK(complete < 20);
}

TEST_CASE("render options out of range are refused") {
  const Scene scene = small_room();
  const NormalsIntegrator normals(scene);
  CHECK_THROWS_WITH(render_with(scene, normals, {.samples = 0}),
                    "0 samples per pixel; valid are 1 to 4194304");
  CHECK_THROWS_WITH(render_with(scene, normals, {.samples = 4, .adaptive = AdaptiveSampling{0, 0.1}}),
                    "a batch of 0 samples; adaptive sampling needs at least 1");
  CHECK_THROWS_WITH(render_with(scene, normals, {.samples = 4, .adaptive = AdaptiveSampling{8, -1}}),
                    "a tolerance of -1; it must be finite and not negative");
  CHECK_THROWS_WITH(render_with(scene, normals, {.seconds = 0}),
                    "0 seconds; they must be finite and more than 0");
}

}  // namespace twinray::test

// SPDX-License-Identifier: Apache-2.0
// Where the camera rays of a picture start and go, and what is reported while it is made.
#include <algorithm>
#include <cmath>

#include "integrators/render.h"
#include "tests/support/catch.h"
#include "tests/support/chi_square.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

/// Keeps the camera rays, of a render on one thread.
class RayKeeper final : public PlainIntegrator {
 public:
  Rgb radiance_of(const CameraSample& sample, SamplerKind, Tracer&) const override {
    rays.push_back(sample);
    return {};
  }
  mutable std::vector<CameraSample> rays;
};

/// Spoils all samples of one pixel but the first.
class SpoiledPixel final : public PlainIntegrator {
  Rgb radiance_of(const CameraSample& sample, SamplerKind, Tracer&) const override {
    const SampleKey& key = sample.key;
    const bool is_spoiled = key.x == 3 && key.y == 2 && key.index >= 1;
    return is_spoiled ? Rgb{NAN, 0, 0} : Rgb{1, 1, 1};
  }
};

constexpr int width = 8, height = 4;

/// Looks along -z from the origin; a pixel in focus is 1 x 1.
Scene scene_with_lens(float radius) {
  Scene scene = scene_of(floor_square(1, -3), {0.5f, 0.5f, 0.5f}, {0, 0, 0}, {0, 0, -1});
  scene.camera.tan_half_width = 1;
  scene.camera.tan_half_height = 0.5f;
  scene.camera.lens_radius = radius;
  scene.camera.focal_distance = 4;
  return scene;
}

std::vector<CameraSample> camera_samples(const Scene& scene, std::uint32_t samples, SamplerKind sampler) {
  const RayKeeper keeper;
  render_with(
      scene, keeper,
      {.width = width, .height = height, .samples = samples, .sampler = sampler, .seed = 5, .threads = 1});
  return keeper.rays;
}

/// Where a ray crosses the plane in focus, in pixels from the top left.
Vec2 frame_point(const Ray& ray) {
  const Vec3 p = ray.origin + ray.direction * 4;
  return {p.x + 0.5f * width, 0.5f * height - p.y};
}

/// Azimuth and squared radius of a point of the unit disc, both uniform in [0, 1] if the point is.
Vec2 polar(float x, float y) { return {float(std::atan2(y, x) / (2 * M_PI) + 0.5), x * x + y * y}; }

int cell(float x, int cells) { return std::clamp(int(x * float(cells)), 0, cells - 1); }

}  // namespace

TEST_CASE("points of the pixel and of the lens are uniform, and independent of each other") {
  constexpr float radius = 0.5f;
  for (const SamplerKind sampler : {SamplerKind::independent, SamplerKind::sobol}) {
    std::vector<std::size_t> counts(256);
    for (const auto& [ray, key, cone] : camera_samples(scene_with_lens(radius), 8192, sampler)) {
      const Vec2 seen = frame_point(ray), lens = polar(ray.origin.x / radius, ray.origin.y / radius);
      REQUIRE(lens.y <= 1 + 1e-6f);
      const Vec2 in_pixel{seen.x - float(key.x), seen.y - float(key.y)};
      REQUIRE(std::min(in_pixel.x, in_pixel.y) >= -1e-5f);
      REQUIRE(std::max(in_pixel.x, in_pixel.y) <= 1 + 1e-5f);
      const int place = cell(in_pixel.x, 4) + 4 * cell(in_pixel.y, 4);
      ++counts[std::size_t(place + 16 * cell(lens.x, 4) + 64 * cell(lens.y, 4))];
    }
    check_uniform(counts, 2, 0.03);
  }
}

TEST_CASE("a picture without a lens has all its rays from one point") {
  for (const auto& [ray, key, cone] : camera_samples(scene_with_lens(0), 16, SamplerKind::sobol))
    CHECK(ray.origin == Vec3{0, 0, 0});
}

TEST_CASE("a picture of one sample a pixel still uses the whole lens") {
  Aabb lens;
  for (const auto& [ray, key, cone] : camera_samples(scene_with_lens(1), 1, SamplerKind::independent)) {
    const Vec2 seen = frame_point(ray);
    CHECK(seen.x - float(key.x) == Approx(0.5).margin(1e-5));
    CHECK(seen.y - float(key.y) == Approx(0.5).margin(1e-5));
    lens.extend(ray.origin);
  }
  CHECK(std::max(lens.lower.x, lens.lower.y) < -0.5f);
  CHECK(std::min(lens.upper.x, lens.upper.y) > 0.5f);
}

TEST_CASE("adaptive sampling goes on where samples were rejected") {
  RenderOptions options{.width = width, .height = height, .samples = 64, .threads = 1};
  options.adaptive = AdaptiveSampling{8, 0.2};
  const Film film = render_with(scene_with_lens(0), SpoiledPixel(), options).film;
  CHECK(film.pixel(3, 2).count == 1);
  CHECK(film.pixel(3, 2).rejected == 63);
  CHECK(film.pixel(4, 2).count < 64);
  CHECK(film.pixel(4, 2).rejected == 0);
}

TEST_CASE("progress counts the samples of a part of the frame, whatever its shape, and all rays") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 2});
  const auto engine = build_accelerator(default_backend(), scene.geometry);
  RenderOptions options{.width = 90, .height = 70, .samples = 3, .threads = 2};
  options.window = PixelRect{20, 10, 70, 17};
  std::vector<RenderProgress> reports;
  const RenderResult result = render(scene, *engine, path, options,
                                     [&](const RenderProgress& progress) { reports.push_back(progress); });
  REQUIRE(reports.size() > 1);
  std::uint64_t before = 0;
  for (const RenderProgress& report : reports) {
    CHECK(report.samples_total == 50 * 7 * 3);
    CHECK(report.samples_done > before);
    before = report.samples_done;
  }
  CHECK(before == 50 * 7 * 3);
  CHECK(reports.back().rays == result.rays.total());
  CHECK(result.rays.camera == 50 * 7 * 3);
}

}  // namespace twinray::test

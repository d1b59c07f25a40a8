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

/// Sees light in one half of the frame: as much as the ray goes to the right.
class Ramp final : public PlainIntegrator {
  Rgb radiance_of(const CameraSample& sample, SamplerKind, Tracer&) const override {
    const float x = sample.ray.direction.x;
    return x > 0 ? Rgb{1 + x, 1, 0} : Rgb{};
  }
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

std::vector<CameraSample> camera_samples(const Scene& scene, std::uint32_t samples, SamplerKind sampler,
                                         const PixelFilter& filter = {}) {
  const RayKeeper keeper;
  render_with(scene, keeper,
              {.width = width,
               .height = height,
               .samples = samples,
               .filter = filter,
               .sampler = sampler,
               .seed = 5,
               .threads = 1});
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
    for (const auto& [ray, key, cone, weight, light, interiors] :
         camera_samples(scene_with_lens(radius), 8192, sampler)) {
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
  for (const auto& [ray, key, cone, weight, light, interiors] :
       camera_samples(scene_with_lens(0), 16, SamplerKind::sobol))
    CHECK(ray.origin == Vec3{0, 0, 0});
}

TEST_CASE("a picture of one sample a pixel still uses the whole lens") {
  Aabb lens;
  for (const auto& [ray, key, cone, weight, light, interiors] :
       camera_samples(scene_with_lens(1), 1, SamplerKind::independent)) {
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

TEST_CASE("samples lie around their pixel as its filter has it") {
  PixelFilter filter = usual_filter(FilterKind::triangle);
  filter.radius = {2, 1};
  std::vector<std::size_t> counts(64);
  for (const auto& [ray, key, cone, weight, light, interiors] :
       camera_samples(scene_with_lens(0), 8192, SamplerKind::independent, filter)) {
    const Vec2 seen = frame_point(ray);
    // From the middle, as parts of the radius, through the integral of the tent: uniform.
    const Vec2 at{(seen.x - float(key.x) - 0.5f) / 2, seen.y - float(key.y) - 0.5f};
    REQUIRE(std::max(std::fabs(at.x), std::fabs(at.y)) <= 1 + 1e-5f);
    const auto up_to = [](float t) { return t < 0 ? (1 + t) * (1 + t) / 2 : 1 - (1 - t) * (1 - t) / 2; };
    ++counts[std::size_t(cell(up_to(at.x), 8) + 8 * cell(up_to(at.y), 8))];
    REQUIRE(weight == 1);
  }
  check_uniform(counts, 1, 0.03);
}

TEST_CASE("a picture is its light under the filter, whatever its sign") {
  // Light of 1 + x on the right of the frame's middle, which lies between pixels 3 and 4: 4 pixels a unit.
  constexpr int samples = 4096;
  constexpr double tolerance = 2e-3;  // Of 4096 stratified samples with weights of both signs.
  bool has_negative = false;
  for (const FilterKind kind : {FilterKind::gaussian, FilterKind::blackman_harris, FilterKind::mitchell}) {
    const PixelFilter filter = usual_filter(kind);
    const auto radius = double(filter.radius.x);
    const Film film =
        render_with(scene_with_lens(0), Ramp(),
                    {.width = width, .height = height, .samples = samples, .filter = filter, .threads = 1})
            .film;
    for (int x = 0; x < width; ++x) {
      double sum = 0, all = 0;
      constexpr int steps = 20000;
      for (int i = 0; i < steps; ++i) {
        const double from_middle = radius * ((2 * i + 1.0) / steps - 1);
        const double value = filter_value(filter, radius, from_middle), to_right = x + 0.5 + from_middle - 4;
        all += value;
        if (to_right > 0) sum += value * (1 + to_right / 4);
      }
      CAPTURE(filter_name(kind), x);
      CHECK(film.pixel(x, 1).mean().r == Approx(sum / all).margin(tolerance));
      has_negative = has_negative || film.pixel(x, 1).mean().r < -1e-3f;
    }
  }
  CHECK(has_negative);
}

TEST_CASE("the one sample of a pixel goes through its middle, whatever its filter") {
  for (const auto& [ray, key, cone, weight, light, interiors] :
       camera_samples(scene_with_lens(0), 1, SamplerKind::sobol, usual_filter(FilterKind::mitchell))) {
    CHECK(frame_point(ray).x - float(key.x) == Approx(0.5).margin(1e-5));
    CHECK(weight == 1);
  }
}

TEST_CASE("nothing comes from beside a fisheye's circle, and all layers know that") {
  Scene scene = scene_with_lens(0);
  scene.camera = with_panorama(scene.camera, Projection::fisheye, 1.5f);
  Image white(1, 1);
  white.at(0, 0) = {1, 1, 1};
  scene.lights.push_back({"sky", EnvironmentLight{std::make_shared<Image>(white)}});
  const PathIntegrator path(scene, {.max_depth = 0});
  RenderOptions options{.width = 24, .height = 16, .samples = 16, .threads = 1};
  options.layers = {Layer::alpha, Layer::depth};
  const Film film = render_with(scene, path, options).film;
  const auto at = [&](int x, int y) { return std::pair(film.pixel(x, y).mean().g, film.value(0, x, y).r); };
  CHECK(at(0, 0) == std::pair(0.0f, 0.0f));
  CHECK(at(3, 8) == std::pair(0.0f, 0.0f));
  CHECK(at(12, 2) == std::pair(1.0f, 1.0f));
  CHECK(at(20, 8).second == 0);
  CHECK(at(18, 8).second == 1);
}

TEST_CASE("pixels around the frame leave those of the frame as they are, and go on where it ends") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 2});
  RenderOptions options{.width = 24, .height = 16, .samples = 8, .threads = 2};
  options.filter = usual_filter(FilterKind::gaussian);
  const Film frame = render_with(scene, path, options).film;
  options.window = PixelRect{-5, -3, 30, 19};
  const Film wide = render_with(scene, path, options).film;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 24; ++x) CHECK(wide.pixel(x, y) == frame.pixel(x, y));
  // A frame that is larger by as much has the same view there, up to its noise.
  Scene larger = small_room();
  larger.camera = fit_frame(larger.camera, 24, 16);
  larger.camera.tan_half_width *= 34.0f / 24;
  larger.camera.tan_half_height *= 22.0f / 16;
  larger.camera.is_stretched = true;
  options.width = 34, options.height = 22, options.window.reset(), options.samples = 256;
  const Film all = render_with(larger, path, options).film;
  options.width = 24, options.height = 16, options.window = PixelRect{-5, -3, 29, 19};
  const Film around = render_with(scene, path, options).film;
  double difference = 0, sum = 0;
  for (int y = 0; y < 22; ++y)
    for (int x = 0; x < 34; ++x) {
      difference += std::fabs(all.pixel(x, y).luminance_mean() - around.pixel(x - 5, y - 3).luminance_mean());
      sum += all.pixel(x, y).luminance_mean();
    }
  CHECK(sum > 0);
  CHECK(difference < 0.05 * sum);
}

}  // namespace twinray::test

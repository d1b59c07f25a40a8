// SPDX-License-Identifier: Apache-2.0
// Camera rays that are made together, in lanes, against each alone: every bit.
#include <string>
#include <vector>

#include "core/instruction_sets.h"
#include "integrators/wave/camera_stage.h"
#include "tests/support/catch.h"
#include "tests/support/lens.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

std::vector<PixelSample> pixel_samples() {
  std::vector<PixelSample> samples;
  for (int i = 0; i < 1500; ++i) samples.push_back({i / 7 % 64, i / 300, std::uint32_t(i % 7)});
  return samples;
}

/// One camera for each way of making rays.
std::vector<Camera> cameras() {
  Camera pinhole = fit_frame(small_room().camera, 64, 48);
  pinhole.frame_center = {0.1f, -0.2f};
  pinhole.clip_near = 0.25f;
  pinhole.clip_far = 7;
  Camera lens = pinhole, pentagon = pinhole, by_distance = pinhole, parallel = pinhole;
  lens.lens_radius = pentagon.lens_radius = 0.2f;
  pentagon.aperture_blades = 5;
  by_distance.clips_by_distance = true;
  parallel.projection = Projection::orthographic;
  Camera glass = pinhole;
  glass.lenses = camera_with_lens_system().lenses;
  return {
      pinhole, lens, pentagon, by_distance, parallel, glass, with_panorama(pinhole, Projection::fisheye, 1)};
}

void require_same(const CameraSample& found, const CameraSample& expected) {
  REQUIRE(found.ray.origin == expected.ray.origin);
  REQUIRE(found.ray.direction == expected.ray.direction);
  REQUIRE(found.ray.t_min == expected.ray.t_min);
  REQUIRE(found.ray.t_max == expected.ray.t_max);
  REQUIRE(found.key.x == expected.key.x);
  REQUIRE(found.key.y == expected.key.y);
  REQUIRE(found.key.index == expected.key.index);
  REQUIRE(found.weight == expected.weight);
  REQUIRE(found.light == expected.light);
  REQUIRE(found.cone.width == expected.cone.width);
  REQUIRE(found.cone.spread == expected.cone.spread);
}

}  // namespace

TEST_CASE("a sample sees less of its pixel the more there were before it") {
  const Camera camera;
  const CameraStage stage(camera, {64, 48, 100, SamplerKind::sobol, 3, {}});
  const std::vector<PixelSample> pixels{{1, 2, 0}, {1, 2, 3}, {1, 2, 4}, {5, 6, 99}};
  std::vector<CameraSample> made(pixels.size());
  stage.make(pixels, made);
  const float whole = pixel_cone(camera, 64, 48).spread, parts[] = {1, 0.5f, 0.25f, 0.125f};
  for (std::size_t i = 0; i < 4; ++i) CHECK(made[i].cone.spread == whole * parts[i]);
}

TEST_CASE("camera rays made together have the bits of each alone") {
  const std::vector<PixelSample> pixels = pixel_samples();
  const PixelFilter filters[] = {{}, usual_filter(FilterKind::mitchell), usual_filter(FilterKind::gaussian)};
  std::vector<CameraSample> expected(pixels.size()), found(pixels.size());
  for (const Camera& camera : cameras())
    for (const PixelFilter& filter : filters)
      for (const SamplerKind kind : {SamplerKind::sobol, SamplerKind::independent}) {
        const CameraSampling sampling{64, 48, 7, kind, 3, filter};
        CameraStage(camera, sampling, "scalar").make(pixels, expected);
        for (const std::string& simd : available_instruction_sets()) {
          CameraStage(camera, sampling, simd).make(pixels, found);
          for (std::size_t i = 0; i < pixels.size(); ++i) {
            CAPTURE(simd, i, int(camera.projection), int(filter.kind));
            require_same(found[i], expected[i]);
          }
        }
      }
}

}  // namespace twinray::test

// SPDX-License-Identifier: Apache-2.0
#include "check/recorded_rays.h"

#include "integrators/render.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace twinray;
using namespace twinray::test;

TEST_CASE("a recorded picture has the rays of its samples, by kind and in order") {
  const Scene scene = small_room();
  const Recording recording{.width = 6, .height = 4, .samples = 3, .max_depth = 2};
  const std::vector<RecordedRay> recorded = record_rays(scene, recording);
  std::size_t sum = 0;
  for (const RayKind kind : {RayKind::camera, RayKind::shadow, RayKind::bounce}) {
    const std::vector<Ray> rays = rays_of_kind(recorded, kind);
    CHECK(rays.size() > 20);
    sum += rays.size();
  }
  CHECK(sum == recorded.size());
  CHECK(recorded[0].kind == RayKind::camera);
  CHECK(rays_of_kind(recorded, RayKind::camera).size() == 6 * 4 * 3);
}

TEST_CASE("one recorded sample a pixel is the ray through its centre") {
  const Scene scene = small_room();
  const std::vector<Ray> rays =
      rays_of_kind(record_rays(scene, {.width = 2, .height = 1, .max_depth = 0}), RayKind::camera);
  REQUIRE(rays.size() == 2);
  const Camera camera = fit_frame(scene.camera, 2, 1);
  const Ray left = camera_ray(camera, {0.25f, 0.5f}, {});
  CHECK(rays[0].direction == left.direction);
  CHECK(rays[0].origin == left.origin);
}

TEST_CASE("a recorded picture has as many rays as the render that traces them") {
  const Scene scene = small_room();
  const std::vector<RecordedRay> recorded = record_rays(scene, {.width = 9, .height = 7});
  const auto accelerator = build_accelerator(Backend::bvh, scene.geometry);
  const PathIntegrator path(scene, {});
  const RenderResult result =
      render(scene, *accelerator, path,
             {.width = 9, .height = 7, .samples = 1, .sampler = SamplerKind::independent});
  CHECK(rays_of_kind(recorded, RayKind::camera).size() == result.rays.camera);
  CHECK(rays_of_kind(recorded, RayKind::shadow).size() == result.rays.shadow);
  CHECK(rays_of_kind(recorded, RayKind::bounce).size() == result.rays.bounce);
}

TEST_CASE("a recorded ray knows the vertex of its path where it starts") {
  const Scene scene = small_room();
  const std::vector<RecordedRay> recorded = record_rays(scene, {.width = 12, .height = 9, .max_depth = 3});
  int vertex = 0;
  bool is_under_way = false;  // Whether the last ray went to the next surface.
  for (const RecordedRay& entry : recorded) {
    if (entry.kind == RayKind::camera)
      vertex = 0;
    else if (is_under_way)
      ++vertex;
    REQUIRE(entry.vertex == vertex);
    is_under_way = entry.kind != RayKind::shadow;
  }
  for (const int start : {1, 2, 3}) CHECK(rays_of_kind(recorded, RayKind::shadow, start).size() > 20);
  CHECK(rays_of_kind(recorded, RayKind::bounce, 1).size() <= 12 * 9);
  CHECK(rays_of_kind(recorded, RayKind::camera, 1).empty());
  CHECK(rays_of_kind(recorded, RayKind::bounce, 3).empty());
}

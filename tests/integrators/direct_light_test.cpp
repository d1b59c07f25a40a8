// SPDX-License-Identifier: Apache-2.0
// What the samples of several lights have in common: nothing.
#include "integrators/direct_light.h"

#include <algorithm>

#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

constexpr std::uint32_t samples_per_light = 8;

/// Two equal square lamps in one place: what a receiver gets from their corners is the same, so that equal
/// draws would be equal points.
Scene scene_with_two_lamps() {
  Scene scene = scene_of(floor_square(9, 0), {0.5f, 0.5f, 0.5f}, {0, 1, 5}, {0, 0, 0});
  for (int i = 0; i < 2; ++i) add_lamp(scene, floor_square(0.5f, 2), {1, 1, 1}, EmissionSide::both);
  return scene;
}

/// The rays of this kind that start at the first surface.
std::vector<Ray> first_rays(const Scene& scene, DirectMethod method, RayKind kind, SamplerKind sampler) {
  const auto engine = build_accelerator(Backend::bvh, scene.geometry);
  const PathIntegrator path(scene,
                            {.max_depth = 1, .direct = method, .samples_per_light = samples_per_light});
  std::vector<RecordedRay> recorded;
  Tracer tracer(*engine, false, &recorded);
  path.radiance(camera_ray(scene.camera, {0.5f, 0.5f}, {}), sampler, {}, tracer);
  std::vector<Ray> rays;
  for (const RecordedRay& entry : recorded)
    if (entry.kind == kind && entry.vertex == 1) rays.push_back(entry.ray);
  return rays;
}

bool are_all_different(const std::vector<Vec3>& points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (length(points[i] - points[k]) < 1e-4f) return false;
  return true;
}

}  // namespace

TEST_CASE("every sample of a light goes to another point, and the points of two lights differ") {
  const Scene scene = scene_with_two_lamps();
  for (const SamplerKind sampler : {SamplerKind::independent, SamplerKind::sobol}) {
    const auto rays = first_rays(scene, DirectMethod::lights, RayKind::shadow, sampler);
    REQUIRE(rays.size() == 2 * samples_per_light);
    std::vector<Vec3> on_lamp;
    for (const Ray& ray : rays) on_lamp.push_back(ray.origin + ray.direction);
    CHECK(are_all_different(on_lamp));
    for (const Vec3& p : on_lamp) CHECK(std::max(std::fabs(p.x), std::fabs(p.z)) <= 0.5f);
  }
}

TEST_CASE("hemisphere sampling takes as many directions as all lights have samples, all different") {
  const Scene scene = scene_with_two_lamps();
  for (const SamplerKind sampler : {SamplerKind::independent, SamplerKind::sobol}) {
    std::vector<Vec3> directions;
    for (const Ray& ray : first_rays(scene, DirectMethod::hemisphere, RayKind::bounce, sampler))
      directions.push_back(ray.direction);
    CHECK(directions.size() == 2 * samples_per_light);
    CHECK(are_all_different(directions));
  }
}

}  // namespace twinray::test

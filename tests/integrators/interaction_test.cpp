// SPDX-License-Identifier: Apache-2.0
// Interpolated normals contradict the geometry: no light may pass through a surface because of it.
#include "integrators/interaction.h"

#include <cmath>

#include "core/random.h"
#include "integrators/normals.h"
#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

constexpr float floor_reflectance = 0.6f;

SurfacePoint point_with(const Vec3& geometric, const Vec3& shading) {
  SurfacePoint point;
  point.geometric_normal = geometric;
  point.shading_normal = shading;
  return point;
}

/// A floor at y = 0, half a side wide, whose shading normal leans towards +x by this angle's sine and cosine.
Mesh leaning_floor(float half, float sine, float cosine) {
  Mesh floor = floor_square(half, 0);
  floor.normals = {{sine, cosine, 0}};
  floor.normal_indices.assign(floor.triangles.size(), {0, 0, 0});
  return floor;
}

/// The leaning floor's centre alone, seen from above; beside and below it a lamp, and a floor that it lights.
Scene scene_below_the_floor() {
  Scene scene = scene_of(leaning_floor(0.5f, 0.8660254f, 0.5f), {1, 1, 1}, {0.2f, 2, 0}, {0, 0, 0});
  scene.camera.tan_half_width = scene.camera.tan_half_height = 1e-4f;
  add_lamp(scene, floor_square(50, -2), {0, 0, 0}, EmissionSide::both);  // a lamp that is off
  scene.materials.back().model = Lambert{{1, 1, 1}};
  Mesh lamp = floor_square(1, -1);
  for (Vec3& p : lamp.positions) p.x += 3;
  add_lamp(scene, std::move(lamp), {5, 5, 5}, EmissionSide::both);
  return scene;
}

RenderOptions options(std::uint32_t samples) {
  return {.width = 4, .height = 4, .samples = samples, .sampler = SamplerKind::independent, .threads = 1};
}

}  // namespace

TEST_CASE("no light is scattered through a surface, whatever its two normals") {
  Scene scene;
  scene.bindings.push_back({});
  scene.materials.push_back({"", Lambert{{1, 1, 1}}});
  const BsdfTable bsdfs(scene);
  Random random(3);
  int black = 0, bright = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 geometric = normalize(random.in_ball());
    const Vec3 shading = normalize(random.in_ball());
    const Vec3 wo = normalize(random.in_ball());
    const Vec3 wi = normalize(random.in_ball());
    const SurfacePoint point = point_with(geometric, shading);
    const Interaction at(bsdfs, point, wo);
    const bool same_side = dot(geometric, wo) * dot(geometric, wi) > 0;
    const bool in_front = dot(at.normal(), wi) > 0;
    const float expected = same_side && in_front ? dot(at.normal(), wi) / pi : 0;
    CHECK(at.scattered(wi).value.g == Approx(expected).margin(1e-6));
    ++(same_side && in_front ? bright : black);
    CHECK(at.is_consistent(wi) == (same_side == in_front));
  }
  CHECK(std::min(black, bright) > 5000);
}

TEST_CASE(
    "the normal that shades is on the viewer's side, and the geometric one where the other looks away") {
  Scene scene;
  scene.bindings.push_back({});
  scene.materials.push_back({"", Lambert{{1, 1, 1}}});
  const BsdfTable bsdfs(scene);
  Random random(4);
  int geometric_ones = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 geometric = normalize(random.in_ball());
    const Vec3 shading = normalize(random.in_ball());
    const Vec3 wo = normalize(random.in_ball());
    const SurfacePoint point = point_with(geometric, shading);
    const Interaction at(bsdfs, point, wo);
    CHECK(dot(at.normal(), wo) > 0);
    CHECK(at.wo_local().z == Approx(dot(at.normal(), wo)).margin(1e-6));
    const Vec3 front = dot(geometric, wo) < 0 ? -geometric : geometric;
    const Vec3 leaning = dot(shading, front) < 0 ? -shading : shading;
    const bool looks_away = dot(leaning, wo) <= 0;
    CHECK(at.normal() == (looks_away ? front : leaning));
    geometric_ones += looks_away;
  }
  CHECK(geometric_ones > 2000);
}

TEST_CASE("normal shading shows the interpolated normal") {
  const Scene scene = scene_of(leaning_floor(9, 0.6f, 0.8f), {1, 1, 1}, {0, 2, 0}, {0, 0, 0});
  const Rgb seen = render_with(scene, NormalsIntegrator(scene), options(1)).film.pixel(2, 2).mean();
  CHECK(seen.r == Approx(0.8));
  CHECK(seen.g == Approx(0.9));
  CHECK(seen.b == Approx(0.5));
}

TEST_CASE("light below a floor does not shine through it where the shading normal leans") {
  const Scene scene = scene_below_the_floor();
  for (const DirectMethod method : {DirectMethod::lights, DirectMethod::hemisphere})
    for (const int depth : {1, 2, 3})
      CHECK(estimate(scene, {.max_depth = depth, .direct = method}, options(256)).mean == 0);
}

TEST_CASE("bounces leave on the viewer's side of both normals") {
  const Scene scene = scene_below_the_floor();
  const auto engine = build_accelerator(Backend::bvh, scene.geometry);
  const PathIntegrator path(scene, {.max_depth = 2});
  int bounces = 0;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    std::vector<RecordedRay> rays;
    Tracer tracer(*engine, false, &rays);
    path.radiance(camera_ray(scene.camera, {0.5f, 0.5f}, {}), SamplerKind::independent, {1, 0, 0, i}, tracer);
    for (const RecordedRay& entry : rays) {
      if (entry.kind != RayKind::bounce) continue;
      CHECK(entry.ray.direction.y > 0);
      CHECK(0.8660254f * entry.ray.direction.x + 0.5f * entry.ray.direction.y > 0);
      ++bounces;
    }
  }
  // A cosine density around a normal that leans by theta has (1 + cos(theta)) / 2 of its weight above.
  CHECK(bounces == Approx(750).margin(70));  // five standard deviations
}

TEST_CASE("a surface whose shading normal looks away from the viewer is as bright as without it") {
  Scene scene = scene_of(leaning_floor(50, 0.8660254f, 0.5f),
                         {floor_reflectance, floor_reflectance, floor_reflectance}, {-3, 1, 0}, {0, 0, 0});
  scene.camera.tan_half_width = scene.camera.tan_half_height = 1e-4f;
  add_light(scene, DirectionalLight{normalize(Vec3{-1, -2, 2}), {3, 3, 3}});
  CHECK(estimate(scene, {.max_depth = 1}, options(16)).mean ==
        Approx(floor_reflectance / M_PI * 3 * (2.0 / 3)).epsilon(render_rounding));
}

}  // namespace twinray::test

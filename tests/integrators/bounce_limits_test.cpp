// SPDX-License-Identifier: Apache-2.0
#include "integrators/bounce_limits.h"

#include <functional>

#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace twinray::test {
namespace {

EnvironmentLight sky() {
  Image map(2, 1);
  map.pixels = {{1, 2, 3}, {3, 2, 0.5f}};
  return {std::make_shared<const Image>(std::move(map))};
}

/// Triangles all around the camera of one material, under a sky and with a lamp among them.
Scene thicket_of(const SurfaceModel& model) {
  Scene scene = scene_of(soup(80, 0.7f, 3), {}, {0, 0.3f, 1.6f}, {0, 0, 0});
  scene.materials[0].model = model;
  add_lamp(scene, floor_square(0.3f, 0.5f), {4, 5, 6}, EmissionSide::both);
  add_light(scene, sky());
  return scene;
}

Film film_of(const Scene& scene, const PathOptions& options) {
  const RenderOptions picture{.width = 16, .height = 12, .samples = 8, .seed = 4, .threads = 1};
  return render_with(scene, PathIntegrator(scene, options), picture).film;
}

struct LimitedKind {
  SurfaceModel model;  ///< That scatters in this way alone.
  int BounceLimits::*limit;
};

const LimitedKind limited_kinds[] = {
    {Lambert{{0.9f, 0.8f, 0.7f}}, &BounceLimits::diffuse},
    {RoughDiffuse{{0.9f, 0.8f, 0.7f}, 0.5f}, &BounceLimits::diffuse},
    {Mirror{{0.9f, 0.8f, 0.7f}}, &BounceLimits::glossy},
    {Conductor{.roughness = {0.4f, 0.4f}}, &BounceLimits::glossy},
    {DiffuseTransmission{{0, 0, 0}, {0.9f, 0.8f, 0.7f}}, &BounceLimits::transmission}};

BounceLimits limited(int BounceLimits::*limit, int bounces) {
  BounceLimits limits;
  limits.*limit = bounces;
  return limits;
}

}  // namespace

TEST_CASE("where surfaces scatter in one way alone, its limit is the depth without the direct bounce") {
  for (const LimitedKind& kind : limited_kinds) {
    const Scene scene = thicket_of(kind.model);
    for (const DirectMethod method : {DirectMethod::mis, DirectMethod::lights})
      for (const int bounces : {0, 1, 3}) {
        CAPTURE(kind.model.index(), bounces, int(method));
        const Film expected = film_of(scene, {.max_depth = bounces + 1, .direct = method});
        const Film found =
            film_of(scene, {.max_depth = 9, .direct = method, .limits = limited(kind.limit, bounces)});
        CHECK(same_bits(found, expected));
        CHECK_FALSE(same_bits(found, film_of(scene, {.max_depth = 9, .direct = method})));
      }
  }
}

TEST_CASE("a limit of one kind leaves the others alone") {
  for (const LimitedKind& kind : limited_kinds) {
    const Scene scene = thicket_of(kind.model);
    BounceLimits others{0, 0, 0};
    others.*kind.limit = BounceLimits::most;
    CAPTURE(kind.model.index());
    CHECK(same_bits(film_of(scene, {.max_depth = 5, .limits = others}), film_of(scene, {.max_depth = 5})));
  }
}

TEST_CASE("a mirror without glossy bounces shows lamps, and no other surface") {
  // Seen at 45 degrees, it shows a square that a point light behind the camera lights.
  Scene scene = scene_of(floor_square(1, 0), {}, {0, 2, 2}, {0, 0, 0});
  scene.materials[0].model = Mirror{};
  scene.camera.tan_half_width = scene.camera.tan_half_height = 1e-3f;
  Mesh square;
  square.positions = {{-9, 1, -2}, {9, 1, -2}, {0, 9, -2}};
  square.triangles = {{0, 1, 2}};
  Scene with_lamp = scene;
  add_lamp(with_lamp, square, {3, 3, 3}, EmissionSide::both);
  const PathOptions no_glossy{.max_depth = 5, .limits = {.glossy = 0}};
  CHECK(estimate(with_lamp, no_glossy, small_picture(4)).mean == Approx(3).epsilon(render_rounding));

  Scene with_wall = scene;
  add_lamp(with_wall, square, {0, 0, 0}, EmissionSide::both);
  with_wall.materials.back().model = Lambert{{0.5f, 0.5f, 0.5f}};
  add_light(with_wall, PointLight{{0, 2, 3}, {10, 10, 10}, {}});
  CHECK(estimate(with_wall, no_glossy, small_picture(4)).mean == 0);
  const double lit = estimate(with_wall, {.max_depth = 2}, small_picture(4)).mean;
  CHECK(lit > 0);
  // One bounce at the mirror, and direct light on the wall behind it.
  const PathOptions one{.max_depth = 5, .limits = {.diffuse = 0, .glossy = 1}};
  CHECK(estimate(with_wall, one, small_picture(4)).mean == Approx(lit).epsilon(render_rounding));
}

TEST_CASE("a coated surface scatters by its coat glossily, and by its base diffusely") {
  const Bsdf bsdf(CoatedDiffuse{.roughness = {0.3f, 0.3f}});
  const Vec3 wo = normalize(Vec3{0.3f, 0.2f, 0.8f});
  CHECK_FALSE(bsdf.sample(wo, 0, {0.3f, 0.6f}).is_diffuse);
  CHECK(bsdf.sample(wo, 0.999f, {0.3f, 0.6f}).is_diffuse);
}

TEST_CASE("a limit of bounces out of range is an error") {
  const Scene scene = small_room();
  CHECK_THROWS_WITH(PathIntegrator(scene, {.limits = {.diffuse = -1}}),
                    "a limit of -1 bounces; it must lie in [0, 100]");
  CHECK_THROWS_WITH(PathIntegrator(scene, {.limits = {.transmission = 101}}),
                    "a limit of 101 bounces; it must lie in [0, 100]");
}

}  // namespace twinray::test

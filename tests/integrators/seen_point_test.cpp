// SPDX-License-Identifier: Apache-2.0
#include "integrators/seen_point.h"

#include "tests/support/catch.h"
#include "tests/support/scenes.h"

namespace twinray::test {

TEST_CASE("a seen point is a surface's, and where there are textures the cone is taken to it") {
  Scene scene = scene_of(floor_square(1, 0), {0.5f, 0.5f, 0.5f}, {0, 2, 0.1f}, {0, 0, 0});
  const Hit hit{.t = 3, .u = 0.25f, .v = 0.25f};
  const Vec3 direction{0, -2, 0};  // Of length 2: the ray's way is 6 long.
  const VertexSampler sampler(SamplerKind::independent, PathKey({.index = 9}), 2);
  RayCone cone{0.5f, 0.1f};
  const SurfacePoint plain = seen_point(scene, hit, direction, sampler, cone);
  const SurfacePoint known = surface_at(*scene.geometry, hit);
  CHECK(plain.position == known.position);
  CHECK(cone.width == 0.5f);
  CHECK(plain.footprint == 0);

  scene.textures = {{"", ConstantTexture{}}};
  const SurfacePoint seen = seen_point(scene, hit, direction, sampler, cone);
  CHECK(seen.position == known.position);
  CHECK(cone.width == Approx(0.5 + 0.1 * 6));
  CHECK(cone.spread == 0.1f);
  CHECK(seen.width == section_width(known, cone.width, direction));
  CHECK(seen.footprint == texture_footprint(*scene.geometry, hit, known, cone.width, direction));
  const Vec2 draw = sampler.draw_2d(Purpose::texture);
  CHECK((seen.texture_draw.x == draw.x && seen.texture_draw.y == draw.y));
}

}  // namespace twinray::test

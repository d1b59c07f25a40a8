// SPDX-License-Identifier: Apache-2.0
#include "integrators/emergence.h"

#include "tests/support/catch.h"
#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace twinray::test {
namespace {

const Vec3 above{0, 0, 1};

/// A ball of radius 1 around the origin.
Scene ball(const Subsurface& below) {
  Scene scene = ball_under_sky(CoatedDiffuse{{0.8f, 0.5f, 0.2f}, {}, 1.5f});
  scene.materials[0].subsurface = below;
  return scene;
}

SurfacePoint top_of_ball(const Scene& scene) {
  return surface_at(*scene.geometry, {.t = 1, .u = 0.5f, .v = 0.5f});
}

}  // namespace

TEST_CASE("light goes below surfaces that have a body, farther than rounding, seen from outside or opaque") {
  const Scene scene = ball({{0.1f, 0.1f, 0.1f}}), plain = ball({});
  const SurfacePoint point = top_of_ball(scene);
  const BsdfTable bsdfs(scene), plain_bsdfs(plain);
  const Vec3 out = point.geometric_normal;
  CHECK(goes_below(scene, Interaction(bsdfs, point, out)));
  CHECK(goes_below(scene, Interaction(bsdfs, point, -out)));
  CHECK_FALSE(goes_below(plain, Interaction(plain_bsdfs, point, out)));
  const Scene thin = ball({Rgb{1, 1, 1} * (0.5f * least_radius * point.offset)});
  const BsdfTable thin_bsdfs(thin);
  CHECK_FALSE(goes_below(thin, Interaction(thin_bsdfs, point, out)));
}

TEST_CASE("a walk comes out at what it hit, or where it went in, seen from outside") {
  const Scene scene = ball({{0.1f, 0.1f, 0.1f}});
  const BsdfTable bsdfs(scene);
  const SurfacePoint point = top_of_ball(scene);
  const Vec3 out = point.geometric_normal;
  Interaction from(bsdfs, point, out);
  from.keep_above();
  const VertexSampler draws(SamplerKind::sobol, PathKey(SampleKey{}), 1);
  RayCone cone;
  const WalkEnd through{.ray = {.origin = {0, 0, 0}, .direction = above},
                        .hit = {.t = 1, .u = 0.5f, .v = 0.5f},
                        .left = {1, 1, 1}};
  const Interaction at = come_out(bsdfs, from, through, draws, Materials::exact, cone);
  CHECK(at.is_emerging());
  CHECK(at.point().position == point.position);
  CHECK(at.side() == Side::outside);
  CHECK(dot(at.normal(), above) > 0);
  WalkEnd back = through;
  back.hit = {};
  const Interaction where = come_out(bsdfs, from, back, draws, Materials::exact, cone);
  CHECK(where.is_emerging());
  CHECK(where.point().position == point.position);
  CHECK(dot(where.normal(), out) > 0);
}

TEST_CASE("a walk into a body is in what its surface lets through, from just below it") {
  const Scene scene = ball({{0.1f, 0.2f, 0.4f}});
  const BsdfTable bsdfs(scene);
  const SurfacePoint point = top_of_ball(scene);
  Interaction from(bsdfs, point, point.geometric_normal);
  from.keep_above();
  const Ray into{.origin = point.position * 0.999f, .direction = -point.geometric_normal};
  const WalkDraws draws(SamplerKind::sobol, PathKey(SampleKey{}), 1);
  WalkBelow walk = walk_from(scene, from, into, {}, {1, 1, 1}, draws);
  CHECK(walk.ray().origin == into.origin);
  CHECK(walk.ray().direction == into.direction);
  CHECK(walk.ray().t_max > 0);
  CHECK(walk.ray().t_max < std::numeric_limits<float>::infinity());
  CHECK_FALSE(walk.end());
  // It meets the body at once, before it is scattered: so it comes out there, in the interiors that it was
  // in.
  const Hit hit{.t = walk.ray().t_max / 2, .u = 0.5f, .v = 0.5f};
  CHECK_FALSE(walk.goes_on(hit));
  REQUIRE(walk.end());
  CHECK(walk.end()->hit == hit);
  CHECK(walk.end()->interiors.empty());
  CHECK(walk.end()->events == 0);
  // From within: whether there is a body at all is seen by what its first ray hits, however far.
  Interaction inside(bsdfs, point, -point.geometric_normal);
  inside.keep_above();
  const Ray outward{.origin = point.position * 1.001f, .direction = point.geometric_normal};
  CHECK(walk_from(scene, inside, outward, {}, {1, 1, 1}, draws).ray().t_max ==
        std::numeric_limits<float>::infinity());
}

}  // namespace twinray::test

// SPDX-License-Identifier: Apache-2.0
// Rays that pass interfaces: what they find behind them, and what absorption leaves of their light.
#include "integrators/passages.h"

#include <limits>

#include "accel/accelerator.h"
#include "integrators/path_reference.h"
#include "integrators/straight_on.h"
#include "tests/support/catch.h"
#include "tests/support/engines.h"
#include "tests/support/estimate.h"
#include "tests/support/film.h"
#include "tests/support/film_bytes.h"
#include "tests/support/fog.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

Material interface(const Interior& interior) {
  Material material{"interface", Interface{}};
  material.interior = interior;
  return material;
}

SphereSet ball_of(float radius) { return {"ball", {{{0, 0, 0}, radius}}}; }

}  // namespace

TEST_CASE("a ray that passes interfaces stays the same ray, and begins behind the last one") {
  Scene scene = scene_of({}, {}, {0, 0, 3}, {0, 0, 0});
  scene.materials = {interface({absorption}), interface({.is_clear = true})};
  scene.bindings = {{0}, {1}};
  scene.geometry = std::make_shared<const Geometry>(std::vector<Shape>{ball_of(1), ball_of(0.5f)});
  const auto engine = build_accelerator(Backend::brute_force, scene.geometry);
  Tracer tracer(*engine, false);
  const Passages passages(scene);
  const auto followed = [&](float t_max) {
    Ray ray{.origin = {0, 0, 3}, .direction = {0, 0, -1}, .t_max = t_max};
    Way way{ray, tracer.hit(ray, RayKind::bounce), {}};
    passages.follow(tracer, way);
    CHECK(way.hit.is_miss());
    return way;
  };
  // It ends within the inner ball, or before any.
  const Way within = followed(3);
  CHECK(within.ray.t_max == 3);
  CHECK(within.ray.t_min == Approx(2.5));
  CHECK(within.interiors.prevailing(scene.materials) == 1);
  CHECK(luminance(within.left) == Approx(left_of(0.5)));
  const Way before = followed(1.5f);
  CHECK(before.ray.t_max == 1.5f);
  CHECK(before.ray.t_min == 0);
  const Way all = followed(std::numeric_limits<float>::infinity());
  CHECK(all.interiors.empty());
  CHECK(all.ray.t_min == Approx(4));
  CHECK(luminance(all.left) == Approx(left_of(1)));
  // A shadow ray that ends in the fog.
  const Ray shadow_ray{.origin = {0, 0, 3}, .direction = {0, 0, -1}, .t_max = 2.25f};
  CHECK(luminance(passages.visibility(tracer, shadow_ray, {})) == Approx(left_of(0.25)));
}

TEST_CASE("a ray in a medium is searched as far as its path goes") {
  Scene scene = scene_of({}, {}, {0, 0, 3}, {0, 0, 0});
  scene.materials = {{"wall", Lambert{}}, {.name = "fog", .model = Interface{}}};
  scene.materials[1].interior = {.absorption = {0.1f, 0.1f, 0.1f}, .scattering = {0.5f, 0.2f, 0.9f}};
  scene.bindings = {{0}};
  scene.geometry = std::make_shared<const Geometry>(std::vector<Shape>{ball_of(1)});
  const auto engine = build_accelerator(Backend::brute_force, scene.geometry);
  Tracer tracer(*engine, false);
  const Passages passages(scene);
  Interiors fog;
  fog.enter(1);
  int scattered = 0;
  constexpr int draws = 500;
  for (int i = 0; i < draws; ++i) {
    const Ray ray{.origin = {0, 0, 3}, .direction = {0, 0, -0.5f}};
    Way way{ray, {}, fog};
    way.flight.emplace(Rgb{1, 1, 1}, (float(i) + 0.5f) / draws);
    Way whole = way;
    whole.hit = tracer.bounce_hit(ray);
    REQUIRE(whole.hit.t == Approx(4));
    whole.ends(scene);
    PassingRay needed(passages, way);
    CHECK(needed.ray().t_max >= 0);
    CHECK_FALSE(needed.goes_on(tracer.bounce_hit(needed.ray())));
    Way found = needed.way();
    found.ends(scene);
    CHECK(found.is_scattered == whole.is_scattered);
    CHECK(found.weight() == whole.weight());
    if (found.is_scattered) {
      CHECK(found.t_scattered() == whole.t_scattered());
      CHECK(found.hit.is_miss());
    }
    scattered += found.is_scattered;
  }
  CHECK((scattered > draws / 4 && scattered < 3 * draws / 4 + draws / 8));
}

TEST_CASE("light that has come into a fibre leaves it at once, and is hidden by it from outside") {
  Scene scene = scene_of({}, {}, {0, 0, 3}, {0, 0, 0});
  scene.materials = {{"fibre", Hair{}}, {"wall", Lambert{}}};
  scene.bindings = {{0}, {1}};
  scene.geometry = std::make_shared<const Geometry>(std::vector<Shape>{ball_of(1), ball_of(2)});
  const auto engine = build_accelerator(Backend::brute_force, scene.geometry);
  Tracer tracer(*engine, false);
  const Passages passages(scene);
  const Ray inside{.origin = {0, 0, 0.5f}, .direction = {0, 0, -1}};
  Way way{inside, tracer.bounce_hit(inside), {}};
  REQUIRE(way.hit.mesh == 0);
  passages.follow(tracer, way);
  CHECK(way.hit.mesh == 1);
  CHECK(way.hit.t == Approx(2.5));
  const Ray outside{.origin = {0, 0, 1.5f}, .direction = {0, 0, -1}, .t_max = 1};
  CHECK(passages.visibility(tracer, outside, {}) == Rgb{});
  const Ray out{.origin = {0, 0, 0.5f}, .direction = {0, 0, 1}, .t_max = 1};
  CHECK(passages.visibility(tracer, out, {}) == Rgb{1, 1, 1});
}

TEST_CASE("an interface hides nothing that lies just behind it") {
  const auto large = [](const char* name, float z) {
    return Mesh{
        .name = name, .positions = {{-900, -900, z}, {900, -900, z}, {0, 900, z}}, .triangles = {{0, 1, 2}}};
  };
  Scene scene = scene_of({}, {}, {0, 0, 3}, {0, 0, 0});
  scene.materials = {interface({absorption}), {"wall", Lambert{}}};
  scene.geometry =
      std::make_shared<const Geometry>(std::vector<Shape>{large("fog", 0), large("wall", -1e-5f)});
  scene.bindings = {{0}, {1}};
  const auto engine = build_accelerator(Backend::brute_force, scene.geometry);
  Tracer tracer(*engine, false);
  const Ray ray{.origin = {0, 0, 1}, .direction = {0, 0, -1}};
  Way way{ray, tracer.hit(ray, RayKind::bounce), {}};
  REQUIRE(way.hit.mesh == 0);
  Passages(scene).follow(tracer, way);
  CHECK(way.hit.mesh == 1);
  CHECK(way.interiors.prevailing(scene.materials) == 0);
  CHECK(luminance(way.left) == 1);
}

TEST_CASE("a clear interface changes no bit of what is seen through it, nor of layers") {
  Scene without = scene_of(floor_square(3, 0), {0.5f, 0.5f, 0.5f}, {0, 2, 3}, {0, 0, 0});
  Image picture(64, 64);
  Random random(8);
  for (Rgb& pixel : picture.pixels)
    pixel = {random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
  without.textures = {{"", ImageTexture{std::make_shared<const MipMap>(std::move(picture))}}};
  without.materials[0].textures = {{MaterialInput::reflectance, 0}};
  Image sky(1, 1);
  sky.pixels[0] = {1, 1, 1};
  add_light(without, EnvironmentLight{std::make_shared<const Image>(std::move(sky))});
  add_light(without, PointLight{{0.3f, 2, 0.5f}, {1, 2, 3}, {}});
  Scene with = without;
  std::vector<Shape> shapes = with.geometry->shapes();
  shapes.push_back(SphereSet{"ball", {{{0, 0.5f, 0}, 1}}});
  with.geometry = std::make_shared<const Geometry>(std::move(shapes));
  with.bindings.push_back({std::uint32_t(with.materials.size())});
  with.materials.push_back(interface({.is_clear = true}));
  RenderOptions options = small_picture(16);
  options.layers = {Layer::depth, Layer::albedo, Layer::position};
  for (const DirectMethod method : {DirectMethod::mis, DirectMethod::lights, DirectMethod::hemisphere}) {
    const Film seen = render_with(without, PathIntegrator(without, {.direct = method}), options).film;
    CHECK(same_bits(render_with(with, PathIntegrator(with, {.direct = method}), options).film, seen));
    CHECK(same_bits(render_with(with, PathReference(with, {.direct = method}), options).film, seen));
  }
}

TEST_CASE("waves have the reference's bits where a light almost lies on a body beside an interface") {
  Scene scene = scene_of(floor_square(2, 0), {}, {0, 3, 5}, {0, 0, 0});
  std::vector<Shape> shapes = scene.geometry->shapes();
  shapes.push_back(SphereSet{"ball", {{{0, -3, 0}, 0.5f}}});
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  Material glass{"glass", Dielectric{.roughness = {0.5f, 0.5f}}};
  glass.interior.absorption = {1, 2, 3};
  scene.materials = {glass, interface({absorption})};
  scene.bindings = {{0}, {1}};
  // Shadow rays begin above the floor, and end below it.
  add_light(scene, PointLight{{0, 1e-6f, 0}, {9999, 9999, 9999}, {}});
  check_waves(scene);
}

TEST_CASE("a ray that goes through an edge of a body goes in and out once") {
  const Vec3 center{0.3f, 0.7f, 0.1f};
  Mesh inner = icosphere(2);
  for (Vec3& p : inner.positions) p = p + center;
  Scene scene = scene_of({}, {}, {0, 0, 4}, {0, 0, 0});
  scene.materials = {interface({absorption}), interface({.is_clear = true})};
  scene.bindings = {{0}, {1}};
  scene.geometry =
      std::make_shared<const Geometry>(std::vector<Shape>{SphereSet{"outer", {{center, 2}}}, inner});
  const auto engine = build_accelerator(Backend::bvh, scene.geometry);
  Tracer tracer(*engine, false);
  const Passages passages(scene);
  Random random(5);
  int more_hits = 0;  // Than two in and two out: on edges some rays hit both triangles, a rounding apart.
  for (int i = 0; i < 20000; ++i) {
    const Triangle& triangle = inner.triangles[std::size_t(i) % inner.triangles.size()];
    const Vec3 on_edge = (inner.positions[triangle[0]] + inner.positions[triangle[1]]) * 0.5f;
    const Vec3 origin = on_edge + (on_edge - center) * 2 + random.in_ball() * 0.3f;
    const Ray ray{.origin = origin, .direction = on_edge - origin};
    Way way{ray, tracer.hit(ray, RayKind::bounce), {}};
    const std::uint64_t before = tracer.counts().bounce;
    passages.follow(tracer, way);
    more_hits += tracer.counts().bounce - before > 4;
    REQUIRE(way.hit.is_miss());
    REQUIRE(way.interiors.empty());
  }
  CHECK(more_hits > 50);
}

TEST_CASE("two hits on an edge of a shape are one crossing") {
  SurfacePoint point;
  point.geometric_normal = {0, 0, 1};
  point.offset = 1e-3f;
  using Crossing = StraightOn::Crossing;
  const Crossing first{point, 2};
  const Vec3 down{0, 0, -2};
  CHECK(StraightOn::are_one(first, {point, 2.0005f}, down));
  CHECK_FALSE(StraightOn::are_one(first, {point, 2.0015f}, down));
  Crossing other{point, 2.0005f};
  other.point.geometric_normal = {0, 0, -1};
  CHECK_FALSE(StraightOn::are_one(first, other, down));
  other = {point, 2.0005f};
  other.point.shape = 1;
  CHECK_FALSE(StraightOn::are_one(first, other, down));
  other = {point, 2.0005f};
  other.point.instance = 1;
  CHECK_FALSE(StraightOn::are_one(first, other, down));
}

}  // namespace twinray::test

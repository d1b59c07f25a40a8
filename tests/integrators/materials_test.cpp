// SPDX-License-Identifier: Apache-2.0
// Surfaces of every model: in scenes whose radiance is known, and by ways of finding light that must agree.
#include <cmath>

#include "core/fresnel.h"
#include "core/surface_model.h"
#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

constexpr float sky_radiance = 2;

/// A ball that fills the picture under a grey sky.
Scene ball_of(const SurfaceModel& model) {
  return ball_under_sky(model, {sky_radiance, sky_radiance, sky_radiance});
}

/// A square that is seen at 45 degrees, and a lamp where a mirror there shows it, which nothing else does.
Scene mirror_scene(const SurfaceModel& model, EmissionSide lamp_side) {
  Scene scene = scene_of(floor_square(1, 0), {}, {0, 2, 2}, {0, 0, 0});
  scene.materials[0].model = model;
  scene.camera.tan_half_width = scene.camera.tan_half_height = 1e-3f;
  Mesh lamp;
  lamp.positions = {{-1, 1, -2}, {1, 1, -2}, {0, 3, -2}};
  lamp.triangles = {{0, 1, 2}};
  add_lamp(scene, lamp, {3, 2, 1}, lamp_side);
  return scene;
}

}  // namespace

TEST_CASE("a mirror shows a lamp with its reflectance, by every way of finding direct light") {
  for (const DirectMethod method : all_methods) {
    const PathOptions path{.max_depth = 1, .direct = method};
    const Scene lit = mirror_scene(Mirror{{0.5f, 0.5f, 0.5f}}, EmissionSide::front);
    CHECK(estimate(lit, path, small_picture(4)).mean ==
          Approx(0.5 * luminance(Rgb{3, 2, 1})).epsilon(render_rounding));
    const Scene dark = mirror_scene(Mirror{}, EmissionSide::back);
    CHECK(estimate(dark, path, small_picture(4)).mean == 0);
    // At depth 0 there is emission alone, and of light scattered twice there is none.
    CHECK(estimate(lit, {.max_depth = 0, .direct = method}, small_picture(4)).mean == 0);
    CHECK(estimate(lit, {.max_depth = 5, .first_depth = 2, .direct = method}, small_picture(4)).mean == 0);
  }
}

TEST_CASE("a smooth metal reflects by Fresnel's equations at the angle that it is seen under") {
  const Conductor metal{.eta = {1.5f, 1.5f, 1.5f}, .k = {2, 2, 2}};
  const double expected = fresnel_conductor(std::sqrt(0.5f), metal.eta, metal.k).r * luminance(Rgb{3, 2, 1});
  const double found =
      estimate(mirror_scene(metal, EmissionSide::both), {.max_depth = 1}, small_picture(4)).mean;
  constexpr double picture = 1e-3;  // Its pixels see the square under slightly other angles.
  CHECK(found == Approx(expected).epsilon(picture));
}

TEST_CASE("a ball that loses no light is as bright as the sky around it, sample by sample") {
  const SurfaceModel models[] = {Mirror{}, Glass{}, Glass{.ior = 0.7f}, Dielectric{.ior = 1.33f},
                                 Dielectric{.is_thin = true}};
  // Paths go on until they leave: the part of the light that is reflected within the ball a hundred times is
  // below rounding.
  for (const SurfaceModel& model : models)
    for (const DirectMethod method : all_methods) {
      CAPTURE(model.index(), int(method));
      const auto found =
          estimate(ball_of(model), {.max_depth = 100, .direct = method, .roulette = {1}}, small_picture(64));
      CHECK(found.mean == Approx(sky_radiance).epsilon(render_rounding));
      CHECK(found.standard_error < render_rounding);
    }
}

TEST_CASE("roulette does not see the change of radiance at boundaries") {
  // Within glass of an index of 3, throughput is a ninth: by that alone two of three paths would be given up.
  const Scene scene = ball_of(Glass{.ior = 3});
  const auto found = estimate(scene, {.max_depth = 100}, small_picture(64));
  CHECK(found.mean == Approx(sky_radiance).epsilon(render_rounding));
  CHECK(found.standard_error < render_rounding);
}

TEST_CASE(
    "a surface that only refracts shows what lies behind it, and nothing where all would be reflected") {
  const Scene outside = ball_of(Refraction{});
  CHECK(estimate(outside, {.max_depth = 2}, small_picture(16)).mean ==
        Approx(sky_radiance).epsilon(render_rounding));
  CHECK(estimate(outside, {.max_depth = 1}, small_picture(16)).mean == 0);  // Still within the ball.
  // From within glass, the sky is seen brighter by the square of the index, and only up to the critical
  // angle.
  Scene inside = ball_of(Refraction{});
  inside.camera = camera_at({0, 0, 0.9f}, {0, 1, 0.9f});
  inside.camera.tan_half_width = inside.camera.tan_half_height = 1e-3f;
  CHECK(estimate(inside, {.max_depth = 1}, small_picture(16)).mean == 0);
  inside.camera.position = {0, 0, 0};
  CHECK(estimate(inside, {.max_depth = 1}, small_picture(16)).mean ==
        Approx(2.25 * sky_radiance).epsilon(render_rounding));
}

TEST_CASE("rough surfaces are equally bright by every way of finding direct light") {
  const SurfaceModel models[] = {Conductor{.roughness = {0.5f, 0.3f}},
                                 Dielectric{.roughness = {0.5f, 0.5f}},
                                 CoatedDiffuse{.roughness = {0.4f, 0.4f}},
                                 CoatedConductor{.roughness = {0.5f, 0.5f}, .coat_roughness = {0.4f, 0.4f}},
                                 DiffuseTransmission{},
                                 RoughDiffuse{},
                                 Microfacet{.alpha = 0.5f}};
  for (const SurfaceModel& model : models) {
    CAPTURE(model.index());
    // Lit by a lamp above, a part of the sky, and a lamp below, whose light some of them let through.
    Scene scene = ball_of(model);
    scene.lights[0].source = AmbientLight{{0, 0.6f, 0.8f}, {1, 1, 1}};
    add_lamp(scene, floor_square(0.8f, 1.5f), {4, 4, 4}, EmissionSide::both);
    add_lamp(scene, floor_square(0.8f, -1.5f), {4, 4, 4}, EmissionSide::both);
    add_lamp(scene, SphereSet{"bulb", {{{1.5f, 0, 1}, 0.5f}}}, {4, 4, 4}, EmissionSide::front);
    const auto found = [&](DirectMethod method, std::uint32_t samples) {
      return estimate(scene, {.max_depth = 2, .direct = method, .roulette = {1}}, small_picture(samples));
    };
    const Estimate expected = found(DirectMethod::mis, 15000);
    check_same_mean(found(DirectMethod::lights, 15000), expected, 0.1);
    check_same_mean(found(DirectMethod::hemisphere, 15000), expected, 0.1);
  }
}

TEST_CASE("a point light is as bright on a rough surface by mis as by light samples") {
  Scene scene = ball_of(Conductor{.roughness = {0.3f, 0.3f}});
  scene.lights.clear();
  add_light(scene, PointLight{{0.5f, 0.5f, 4}, {10, 10, 10}, {}});
  const Estimate by_lights =
      estimate(scene, {.max_depth = 1, .direct = DirectMethod::lights}, small_picture(16));
  CHECK(estimate(scene, {.max_depth = 1}, small_picture(16)).mean == by_lights.mean);
  CHECK(by_lights.mean > 0.1);
}

TEST_CASE("an ambient light is seen in a mirror, not by the camera") {
  Scene scene = ball_of(Mirror{{0.5f, 0.5f, 0.5f}});
  scene.lights.clear();
  add_light(scene, AmbientLight{{0, 0, 1}, {1, 1, 1}});
  CHECK(estimate(scene, {.max_depth = 1}, small_picture(4)).mean == Approx(0.5).epsilon(render_rounding));
  CHECK(estimate(scene, {.max_depth = 0}, small_picture(4)).mean == 0);
}

TEST_CASE("a clamp bounds light of two bounces and more, and keeps its color") {
  const Scene once = mirror_scene(Mirror{}, EmissionSide::front);
  CHECK(estimate(once, {.max_depth = 5, .clamp = 0.5f}, small_picture(4)).mean ==
        Approx(luminance(Rgb{3, 2, 1})).epsilon(render_rounding));
  Scene twice = ball_of(Glass{});
  twice.lights[0].source = constant_sky({4, 2, 1});
  const PathOptions clamped{.max_depth = 100, .clamp = 2};
  const RenderResult result = render_with(twice, PathIntegrator(twice, clamped), small_picture(64));
  // All light has gone through the ball: two bounces at least, but for what it reflects, one.
  const Rgb expected = Rgb{2, 1, 0.5f};
  const Rgb mean = mean_image(result.film).at(1, 1);
  const double reflected = fresnel_dielectric(1, 1.5f);
  CHECK(mean.r == Approx(expected.r * (1 + reflected)).epsilon(0.05));
  CHECK(mean.g / mean.r == Approx(0.5).epsilon(render_rounding));
  CHECK(mean.b / mean.r == Approx(0.25).epsilon(render_rounding));
}

TEST_CASE("regularized, a mirror behind a diffuse surface lets lights be found") {
  // A floor sees a small lamp by way of a mirror beside it: only a scattered ray finds that light, unless the
  // mirror is rough.
  Scene scene = mirror_scene(Lambert{{0.8f, 0.8f, 0.8f}}, EmissionSide::front);
  scene.materials.push_back({"mirror", Mirror{}});
  std::vector<Shape> shapes = scene.geometry->shapes();
  Mesh mirror;
  mirror.positions = {{-3, -1, 2.5f}, {3, -1, 2.5f}, {0, 5, 2.5f}};
  mirror.triangles = {{0, 1, 2}};
  shapes.push_back(mirror);
  scene.bindings.push_back({std::uint32_t(scene.materials.size() - 1)});
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  const PathOptions caustic{.max_depth = 2, .first_depth = 2, .direct = DirectMethod::lights};
  PathOptions regularized = caustic;
  regularized.regularize = true;
  const Estimate exact = estimate(scene, caustic, small_picture(4096));
  const Estimate rough = estimate(scene, regularized, small_picture(4096));
  CHECK(rough.mean == Approx(exact.mean).epsilon(0.5));
  CHECK(rough.standard_error < 0.6 * exact.standard_error);
  // Light that comes by mirrors alone is as it was.
  const Scene direct = mirror_scene(Mirror{}, EmissionSide::front);
  CHECK(estimate(direct, {.max_depth = 5, .regularize = true}, small_picture(4)).mean ==
        Approx(luminance(Rgb{3, 2, 1})).epsilon(render_rounding));
}

TEST_CASE("a mixture is its second material at the stated part of its points") {
  Scene scene = ball_of(Lambert{});
  scene.materials = {{"black", Lambert{{0, 0, 0}}}, {"silver", Mirror{}}, {"both", Mix{0, 1, 0.3f}}};
  scene.bindings[0].material = 2;
  constexpr int points = 20000;
  int silver = 0;
  Random random(3);
  for (int i = 0; i < points; ++i) {
    SurfacePoint point;
    point.position = random.in_ball();
    const std::uint32_t material = material_at(scene, point);
    REQUIRE(material <= 1);
    REQUIRE(material == material_at(scene, point));
    silver += int(material);
  }
  const double deviation = std::sqrt(points * 0.3 * 0.7);
  CHECK(std::fabs(silver - points * 0.3) < 4 * deviation);
  check_mean(estimate(scene, {.max_depth = 1}, small_picture(4096)), 0.3 * sky_radiance, 0.05);
}

}  // namespace twinray::test

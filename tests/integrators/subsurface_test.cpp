// SPDX-License-Identifier: Apache-2.0
// Light below surfaces, as a whole picture shows it: held to the surfaces that it stands for, and furnaces.
#include "core/subsurface.h"
#include <cmath>

#include "accel/accelerator.h"
#include "integrators/furnace.h"
#include "integrators/path_reference.h"
#include "integrators/replay.h"
#include "tests/support/catch.h"
#include "tests/support/engines.h"
#include "tests/support/estimate.h"
#include "tests/support/film.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"
#include "tests/support/traced_records.h"

namespace twinray::test {
namespace {

constexpr Rgb skin{0.8f, 0.5f, 0.2f};

Principled layered(float subsurface_weight) {
  Principled model{.base_color = skin, .subsurface_weight = subsurface_weight, .subsurface_color = skin};
  model.specular_roughness = 0.4f;
  model.coat_weight = 0.7f, model.coat_roughness = 0.2f;
  model.fuzz_weight = 0.4f;
  return model;
}

/// A ball of radius 1 around the origin, of which the camera sees a small part along -z; a lamp above.
Scene lit_ball(const SurfaceModel& model, const Subsurface& below) {
  Scene scene = scene_of({}, {}, {0, 0, 3}, {0, 0, 0});
  scene.geometry = std::make_shared<const Geometry>(std::vector<Shape>{SphereSet{"ball", {{{0, 0, 0}, 1}}}});
  scene.materials = {{.name = "ball", .model = model, .subsurface = below}};
  scene.bindings = {{0}};
  scene.camera.tan_half_width = scene.camera.tan_half_height = 1e-3f;
  add_light(scene, constant_sky({0.2f, 0.2f, 0.2f}));
  add_lamp(scene, SphereSet{"lamp", {{{2, 2, 3}, 0.5f}}}, {20, 20, 20}, EmissionSide::front);
  return scene;
}

/// Bodies of several kinds in a room; one with an eye within.
Scene scene_of_bodies() {
  Scene scene = small_room();
  std::vector<Shape> shapes = scene.geometry->shapes();
  const auto add = [&](const SurfaceModel& model, const Subsurface& below, const Sphere& ball) {
    scene.bindings.push_back({std::uint32_t(scene.materials.size())});
    scene.materials.push_back({.name = "", .model = model, .subsurface = below});
    shapes.push_back(SphereSet{"", {ball}});
  };
  add(CoatedDiffuse{skin, {}, 1.33f}, {{0.3f, 0.1f, 0.05f}, 0.5f}, {{0, -0.2f, 0.1f}, 0.5f});
  add(Lambert{}, {}, {{0, -0.2f, 0.2f}, 0.2f});
  add(CoatedDiffuse{skin, {0.3f, 0.3f}, 1.5f}, {{0.1f, 0.1f, 0.4f}, -0.3f}, {{0.5f, 0.4f, 0}, 0.3f});
  add(layered(0.7f), {{0.05f, 0.1f, 0.2f}}, {{-0.5f, 0.3f, 0.2f}, 0.35f});
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  add_light(scene, PointLight{{0.2f, 0.4f, 0.3f}, {0.3f, 0.2f, 0.1f}, {}});
  check_scene(scene);
  return scene;
}

}  // namespace

TEST_CASE("a body that absorbs nothing cannot be told from a white sky, by every way of finding light") {
  for (const SurfaceModel& model :
       {SurfaceModel(CoatedDiffuse{white, {}, 1.5f}), SurfaceModel(CoatedDiffuse{white, {}, 1})})
    for (const DirectMethod method : all_methods) {
      CAPTURE(std::get<CoatedDiffuse>(model).ior, int(method));
      Scene scene = ball_under_sky(model);
      scene.materials.back().subsurface = {{0.5f, 0.2f, 1}, 0.4f};
      check_mean(estimate(scene, {.max_depth = 30, .direct = method, .roulette = {1}}, small_picture(1024)),
                 1, 0.2);
    }
}

TEST_CASE("where light goes no way below, a body is what its base would be, by lamps and by directions") {
  for (const SurfaceModel& model :
       {SurfaceModel(CoatedDiffuse{skin, {}, 1.5f}), SurfaceModel(CoatedDiffuse{skin, {0.3f, 0.3f}, 1.33f}),
        SurfaceModel(layered(1)), SurfaceModel(layered(0.4f))})
    for (const DirectMethod method : {DirectMethod::mis, DirectMethod::lights}) {
      CAPTURE(model.index(), int(method));
      const PathOptions path{.max_depth = 3, .direct = method};
      const auto seen = [&](const Subsurface& below) {
        return estimate(lit_ball(model, below), path, small_picture(4096));
      };
      check_same_mean(seen({{0.002f, 0.002f, 0.002f}}), seen({}), 0.05);
    }
}

TEST_CASE("where light goes less far below than rounding, it is reflected where it is") {
  const CoatedDiffuse model{skin, {}, 1.5f};
  const auto film = [&](const Subsurface& below) {
    const Scene scene = lit_ball(model, below);
    return render_with(scene, PathReference(scene, {.max_depth = 3}), small_picture(64)).film;
  };
  const Film bare = film({});
  CHECK(same_bits(film({{1e-9f, 1e-9f, 1e-9f}}), bare));
  CHECK_FALSE(same_bits(film({{0.01f, 1e-9f, 1e-9f}}), bare));
  // And a channel in which it does is as bright as it is without a body.
  const auto green = [&](const Subsurface& below) {
    Scene scene = lit_ball(CoatedDiffuse{{0, 0.5f, 0}, {}, 1.5f}, below);
    return estimate(scene, {.max_depth = 3}, small_picture(4096));
  };
  check_same_mean(green({{0.01f, 1e-9f, 1e-9f}}), green({}), 0.05);
}

TEST_CASE("a path that comes out beyond what covers a body is in what is there") {
  // A drop of water, and fog, on a part of the ball.
  const auto seen = [](const SurfaceModel& model, const Interior& interior) {
    Scene scene = ball_under_sky(CoatedDiffuse{white, {}, 1.33f});
    scene.materials.back().subsurface = {{0.5f, 0.5f, 0.5f}};
    std::vector<Shape> shapes = scene.geometry->shapes();
    const auto& ball = std::get<SphereSet>(shapes[0]).spheres[0];
    const Vec3 front = ball.center + normalize(scene.camera.position - ball.center) * ball.radius;
    shapes.push_back(SphereSet{"drop", {{front, 0.3f * ball.radius}}});
    scene.bindings.push_back({std::uint32_t(scene.materials.size())});
    scene.materials.push_back({.name = "drop", .model = model, .interior = interior});
    scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
    scene.camera = camera_at(scene.camera.position, front);
    scene.camera.tan_half_width = scene.camera.tan_half_height = 1e-3f;
    return estimate(scene, {.max_depth = 100, .roulette = {1}}, small_picture(1024));
  };
  check_mean(seen(Dielectric{.ior = 1.5f}, {}), 1, 0.2);
  // What it absorbs of the light that comes back through it, and of nothing else.
  const double left = seen(Interface{}, {.absorption = {0.1f, 0.1f, 0.1f}}).mean;
  CHECK(left > 0.8);
  CHECK(left < 0.99);
}

TEST_CASE("what is let into a body sees no other body around it from within") {
  // A ball that is let into here and there, seen from its middle.
  const auto film = [](const Subsurface& below) {
    Scene scene = ball_under_sky(CoatedDiffuse{});
    scene.materials = {{.name = "body", .model = CoatedDiffuse{skin, {}, 1.5f}, .subsurface = below},
                       {.name = "glass", .model = Dielectric{}},
                       {.name = "mix", .model = Mix{0, 1, 0.5f}}};
    scene.bindings = {{2}};
    const auto& ball = scene.geometry->sphere_set(0)->spheres[0];
    scene.camera = camera_at(ball.center, ball.center + Vec3{0, 0, 1});
    return render_with(scene, PathReference(scene, {.max_depth = 5}), small_picture(64)).film;
  };
  CHECK(same_bits(film({{0.1f, 0.1f, 0.1f}}), film({})));
}

TEST_CASE("light enters a body as it comes to the true surface, whatever other normals say") {
  const Scene scene = lit_ball(CoatedDiffuse{skin, {}, 1}, {{0.1f, 0.1f, 0.1f}});
  const BsdfTable bsdfs(scene, Materials::exact);
  SurfacePoint point;
  point.position = point.geometric_normal = {0, 0, 1};
  double cosines = 0;
  constexpr int count = 4096;
  Random random(3);
  for (const Vec3& shading : {Vec3{0, 0, 1}, normalize(Vec3{0.8f, 0, 0.6f})}) {
    point.shading_normal = shading;
    Interaction at(bsdfs, point, normalize(Vec3{0.3f, 0, 1}));
    at.keep_above();
    cosines = 0;
    for (int i = 0; i < count; ++i) {
      const auto into = scatter(at, {1, 1, 1}, 0.5f, in_square(random));
      REQUIRE(into);
      CHECK(into->is_below);
      cosines -= double(into->direction.z) / count;
    }
    // The mean cosine of a matte surface.
    CHECK(cosines == Approx(2.0 / 3).margin(0.015));
  }
}

TEST_CASE("a body that is seen from within, with nothing beyond, reflects where it is") {
  // A ball about the camera, whose outside is outside: its inside is dark, and no body.
  const auto film = [](const Subsurface& below) {
    Scene scene = lit_ball(CoatedDiffuse{white, {}, 1.5f}, below);
    scene.geometry = std::make_shared<const Geometry>(
        std::vector<Shape>{SphereSet{"ball", {{{0, 0, 0}, 1}}}, SphereSet{"lamp", {{{0, 0.5f, 0}, 0.1f}}}});
    scene.camera = camera_at({0, 0, 0}, {0, 0, 1});
    return estimate_of(render_with(scene, PathReference(scene, {.max_depth = 3}), small_picture(1024)).film);
  };
  check_same_mean(film({{0.1f, 0.1f, 0.1f}}), film({}), 0.2);
}

TEST_CASE("what comes out of a body leaves through its layers, in directions of a matte surface") {
  const CoatedDiffuse model{skin, {}, 2.5f};
  const Scene scene = lit_ball(model, {{0.1f, 0.1f, 0.1f}});
  const BsdfTable bsdfs(scene, Materials::exact);
  SurfacePoint point;
  point.position = point.geometric_normal = point.shading_normal = {0, 0, 1};
  const Interaction at = Interaction::emerging(bsdfs, point, 0, normalize({0.5f, 0, 0.3f}), {});
  CHECK(at.is_emerging());
  CHECK(at.normal() == Vec3{0, 0, 1});
  const Bsdf bsdf{SurfaceModel(model)};
  for (const float cosine : {0.1f, 0.5f, 0.9f}) {
    const Vec3 wi{std::sqrt(1 - cosine * cosine), 0, cosine};
    const auto [value, pdf] = at.scattered(wi);
    CHECK(value.g == Approx(bsdf.from_below(wi).g * cosine));
    CHECK(pdf == Approx(cosine / pi));
    CHECK(is_black(at.scattered(-wi).value));
  }
  const BsdfSample sample = at.sample(0, {0.3f, 0.6f});
  CHECK(sample.is_diffuse);
  CHECK(sample.pdf == Approx(sample.wi.z / pi));
}

TEST_CASE("light comes out of a body where no lamp shines on it") {
  // A lamp behind the ball.
  const auto seen = [](const Subsurface& below) {
    Scene scene = lit_ball(CoatedDiffuse{skin, {}, 1.33f}, below);
    scene.lights.clear();
    scene.bindings[1].light = no_light;
    add_light(scene, PointLight{{0, 0, -3}, {9, 9, 9}, {}});
    return estimate(scene, {.max_depth = 1}, small_picture(1024)).mean;
  };
  CHECK(seen({}) == 0);
  CHECK(seen({{1, 1, 1}}) > 10 * seen({{0.2f, 0.2f, 0.2f}}));
  CHECK(seen({{0.2f, 0.2f, 0.2f}}) > 0);
}

TEST_CASE("a lit walk through a body counts as one bounce") {
  const Scene scene = lit_ball(CoatedDiffuse{skin, {}, 1}, {{0.1f, 0.1f, 0.1f}});
  CHECK(estimate(scene, {.max_depth = 0}, small_picture(4)).mean == 0);
  CHECK(estimate(scene, {.max_depth = 1}, small_picture(256)).mean > 0.1);
}

TEST_CASE("in a room of matte surfaces and bodies, diffuse bounces are bounces") {
  Scene scene = small_room();
  std::vector<Shape> shapes = scene.geometry->shapes();
  shapes.push_back(SphereSet{"body", {{{0, -0.2f, 0.1f}, 0.5f}}});
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  scene.bindings.push_back({std::uint32_t(scene.materials.size())});
  scene.materials.push_back(
      {.name = "body", .model = CoatedDiffuse{skin, {}, 1}, .subsurface = {{0.1f, 0.1f, 0.1f}}});
  const auto film = [&](const PathOptions& path) {
    return render_with(scene, PathReference(scene, path), small_picture(256)).film;
  };
  CHECK(
      same_bits(film({.max_depth = 20, .limits = {.diffuse = 1}, .roulette = {1}}), film({.max_depth = 2})));
}

TEST_CASE("bodies have the same bits on all engines, instruction sets and threads") {
  const Scene scene = scene_of_bodies();
  check_engines(scene, PathIntegrator(scene, {.max_depth = 3}, "scalar"));
  check_engines(scene, PathIntegrator(scene, {.max_depth = 3}));
}

TEST_CASE("all ways of finding light agree on what comes out of bodies") {
  const Scene scene = scene_of_bodies();
  const auto seen = [](const Scene& of, DirectMethod method) {
    return estimate(of, {.max_depth = 3, .direct = method}, small_picture(4096));
  };
  check_same_mean(seen(scene, DirectMethod::lights), seen(scene, DirectMethod::mis), 0.3);
  // Which never finds points of light.
  Scene lamps = scene;
  lamps.lights.pop_back();
  check_same_mean(seen(lamps, DirectMethod::hemisphere), seen(lamps, DirectMethod::mis), 0.3);
}

TEST_CASE("what comes out of a body is diffuse light, and the parts of a picture add up to it") {
  const Scene scene = lit_ball(CoatedDiffuse{skin, {}, 1}, {{0.1f, 0.1f, 0.1f}});
  RenderOptions options = small_picture(256);
  options.light_paths = true;
  const Film film = render_with(scene, PathIntegrator(scene, {.max_depth = 1}), options).film;
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) {
      const std::vector<Rgb> parts = parts_at(film, Division::paths, x, y);
      const Rgb direct = parts[std::size_t(LightPath::diffuse_direct)], whole = film.pixel(x, y).mean();
      CHECK_FALSE(is_black(direct));
      CHECK(direct.g == Approx(whole.g).epsilon(1e-5));
      CHECK(is_black(parts[std::size_t(LightPath::transmission_direct)]));
    }
}

TEST_CASE("a replayed path names its walks below surfaces, and its terms add up to its radiance") {
  const Scene scene = scene_of_bodies();
  const PathIntegrator integrator(scene, {.max_depth = 3});
  const auto engine = build_accelerator(default_backend(), scene.geometry);
  const RenderOptions options = small_picture(64);
  int walks = 0, lost = 0;
  for (std::uint32_t index = 0; index < 64; ++index) {
    const Replay made = replay({scene, *engine, integrator}, {.max_depth = 3}, options, {1, 2, index});
    CHECK(made.path.sum() == made.radiance);
    const PathVertex& last = made.path.vertices().back();
    const bool is_lost = last.scattering && last.scattering->next && last.scattering->next->is_below;
    CHECK(is_lost == (made.path.end() == PathEnd::below));
    lost += is_lost;
    for (const PathVertex& vertex : made.path.vertices()) {
      walks += vertex.arrival.events_below.has_value();
      if (vertex.arrival.events_below) CHECK(vertex.surface->is_emerging());
    }
  }
  CHECK(walks > 0);
  CHECK(lost > 0);
}

TEST_CASE("a furnace takes the base for what is below it") {
  const Scene scene = lit_ball(CoatedDiffuse{skin, {}, 1.5f}, {{0.1f, 0.1f, 0.1f}});
  const Scene bare = lit_ball(CoatedDiffuse{skin, {}, 1.5f}, {});
  CHECK(same_bits(render_with(scene, FurnaceIntegrator(scene, 3), small_picture(16)).film,
                  render_with(bare, FurnaceIntegrator(bare, 3), small_picture(16)).film));
}

}  // namespace twinray::test

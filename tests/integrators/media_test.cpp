// SPDX-License-Identifier: Apache-2.0
// Light that is scattered on its way between surfaces: held to closed forms, furnaces and other routes.
#include <cmath>

#include "accel/accelerator.h"
#include "core/phase_function.h"
#include "integrators/furnace.h"
#include "integrators/path_reference.h"
#include "integrators/replay.h"
#include "tests/support/catch.h"
#include "tests/support/engines.h"
#include "tests/support/estimate.h"
#include "tests/support/film.h"
#include "tests/support/scenes.h"
#include "tests/support/traced_records.h"

namespace twinray::test {
namespace {

constexpr Interior white_fog{.scattering = {1, 2, 4}, .anisotropy = 0.4f};
constexpr Interior smoke{
    .absorption = {0.2f, 0.3f, 0.1f}, .scattering = {0.5f, 0.3f, 0.9f}, .anisotropy = -0.3f};

/// A ball of radius 1 around the origin, of a model and filled; the camera sees a small part of it, along -z.
Scene ball_of(const SurfaceModel& model, const Interior& interior) {
  Scene scene = scene_of({}, {}, {0, 0, 3}, {0, 0, 0});
  scene.geometry = std::make_shared<const Geometry>(std::vector<Shape>{SphereSet{"ball", {{{0, 0, 0}, 1}}}});
  scene.materials = {{.name = "ball", .model = model, .interior = interior}};
  scene.bindings = {{0}};
  scene.camera.tan_half_width = scene.camera.tan_half_height = 1e-3f;
  return scene;
}

Scene under(Scene scene, const LightSource& light) {
  add_light(scene, light);
  return scene;
}

Interior grey(float absorption, float scattering) {
  return {.absorption = {absorption, absorption, absorption},
          .scattering = {scattering, scattering, scattering}};
}

/// In a box around the origin.
std::shared_ptr<const DensityGrid> grid_of(const DensityGrid::Size& size, const std::vector<float>& values,
                                           double half) {
  const Transform to_unit =
      Transform::translation(0.5, 0.5, 0.5) * Transform::scaling(0.5 / half, 0.5 / half, 0.5 / half);
  return std::make_shared<const DensityGrid>(size, values, to_unit);
}

/// Of light that comes from +x and is scattered once within a ball of a grey medium, towards the camera at
/// +z.
double scattered_once(double absorption, double scattering, double phase) {
  const double extinction = absorption + scattering;
  constexpr int steps = 10000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double z = 1 - 2 * (i + 0.5) / steps;
    const double way = std::sqrt(1 - z * z) + (1 - z);
    sum += scattering * phase * std::exp(-extinction * way) * 2 / steps;
  }
  return sum;
}

/// Fog, smoke and bodies of both, with lamps in them and around them.
Scene scene_of_media() {
  Scene scene = small_room();
  std::vector<Shape> shapes = scene.geometry->shapes();
  const auto add = [&](const SurfaceModel& model, const Interior& interior, const Sphere& ball) {
    scene.bindings.push_back({std::uint32_t(scene.materials.size())});
    scene.materials.push_back({.name = "", .model = model, .interior = interior});
    shapes.push_back(SphereSet{"", {ball}});
  };
  add(Interface{}, white_fog, {{0, -0.2f, 0.1f}, 0.7f});
  add(Interface{}, smoke, {{0.3f, 0, 0.2f}, 0.3f});
  add(Interface{}, {.absorption = {2, 1, 0}}, {{-0.4f, -0.3f, 0}, 0.4f});
  Interior uneven = smoke;
  uneven.density = 0;
  scene.densities = {grid_of({2, 3, 2}, {0, 9, 4, 1, 0, 3, 8, 0, 2, 5, 9, 1}, 0.6)};
  add(Interface{}, uneven, {{0.2f, 0.5f, -0.3f}, 0.5f});
  add(Dielectric{.ior = 1.3f}, smoke, {{-0.3f, 0.3f, 0.3f}, 0.25f});
  add(Dielectric{.ior = 1.2f, .roughness = {0.3f, 0.3f}}, white_fog, {{0.5f, -0.5f, -0.2f}, 0.3f});
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  add_light(scene, PointLight{{0.2f, 0.4f, 0.3f}, {0.3f, 0.2f, 0.1f}, {}});
  scene.materials.push_back({.name = "air", .model = Interface{}, .interior = grey(0.01f, 0.1f)});
  scene.atmosphere = std::uint32_t(scene.materials.size() - 1);
  check_scene(scene);
  return scene;
}

}  // namespace

TEST_CASE("a body that scatters all light cannot be told from a white sky, by every way of finding light") {
  for (const SurfaceModel& model : {SurfaceModel(Interface{}), SurfaceModel(Dielectric{.ior = 1.4f})})
    for (const DirectMethod method : all_methods) {
      CAPTURE(model.index(), int(method));
      const Scene scene = under(ball_of(model, white_fog), constant_sky({1, 1, 1}));
      const PathOptions path{.max_depth = 100, .direct = method, .roulette = {1}};
      check_mean(estimate(scene, path, small_picture(1024)), 1, 0.2);
    }
  const Dielectric frosted{.ior = 1.4f, .roughness = {0.3f, 0.3f}};
  const Scene scene = under(ball_of(frosted, white_fog), constant_sky({1, 1, 1}));
  check_mean(estimate(scene, {.max_depth = 100, .roulette = {1}}, small_picture(1024)), 1, 0.2);
}

TEST_CASE("a body as bright as the sky cannot be told from it, whatever it absorbs and scatters") {
  Interior ember = smoke;
  ember.glow.radiance = {1, 1, 1};
  Interior clear = ember;
  clear.scattering = {};
  const auto check_unseen = [](const Scene& scene, DirectMethod method = DirectMethod::mis) {
    const PathOptions path{.max_depth = 100, .direct = method, .roulette = {1}};
    check_mean(estimate(scene, path, small_picture(1024)), 1, 0.2);
  };
  for (const DirectMethod method : all_methods)
    check_unseen(under(ball_of(Interface{}, ember), constant_sky({1, 1, 1})), method);
  // Within glass radiance is larger, by its index of refraction squared.
  Interior dense = ember;
  dense.glow.radiance = dense.glow.radiance * (1.4f * 1.4f);
  check_unseen(under(ball_of(Dielectric{.ior = 1.4f}, dense), constant_sky({1, 1, 1})));
  // Where light is absorbed alone, nothing is left to chance.
  CHECK(estimate(under(ball_of(Interface{}, clear), constant_sky({1, 1, 1})), {}, small_picture(4)).mean ==
        Approx(1).epsilon(1e-5));
  ember.density = clear.density = 0;
  for (const Interior& uneven : {ember, clear}) {
    Scene scene = under(ball_of(Interface{}, uneven), constant_sky({1, 1, 1}));
    scene.densities = {grid_of({2, 3, 2}, {0, 9, 4, 1, 0, 3, 8, 0, 2, 5, 9, 1}, 0.6)};
    check_unseen(scene);
  }
  // In a mirror, too, within each other, and around everything.
  Scene nested = under(ball_of(Interface{}, ember), constant_sky({1, 1, 1}));
  nested.densities = {grid_of({1, 1, 1}, {2}, 0.6)};
  std::vector<Shape> shapes = nested.geometry->shapes();
  shapes.push_back(SphereSet{"inner", {{{0, 0.1f, 0}, 0.5f}}});
  shapes.push_back(SphereSet{"mirror", {{{0.5f, 0, -0.2f}, 0.3f}}});
  nested.geometry = std::make_shared<const Geometry>(std::move(shapes));
  nested.materials.push_back({"inner", Interface{}, {}, grey(1, 2)});
  nested.materials.back().interior.glow.radiance = {1, 1, 1};
  nested.materials.push_back({"mirror", Mirror{}});
  nested.bindings.push_back({1});
  nested.bindings.push_back({2});
  check_unseen(nested);
  nested.lights.clear();
  nested.materials.push_back({"air", Interface{}, {}, grey(0.1f, 0.2f)});
  nested.materials.back().interior.glow.radiance = {1, 1, 1};
  nested.atmosphere = 3;
  check_unseen(nested);
}

TEST_CASE("a replayed path has what media emit, and its terms add up to its radiance") {
  Interior ember = smoke;
  ember.glow.radiance = {1, 2, 3};
  const Scene scene = under(ball_of(Dielectric{.ior = 1.4f}, ember), constant_sky({1, 1, 1}));
  const PathIntegrator integrator(scene, {.max_depth = 3});
  const auto engine = build_accelerator(default_backend(), scene.geometry);
  int glows = 0;
  for (std::uint32_t index = 0; index < 64; ++index) {
    const Replay made =
        replay({scene, *engine, integrator}, {.max_depth = 3}, small_picture(64), {1, 2, index});
    CHECK(made.path.sum() == made.radiance);
    for (const PathVertex& vertex : made.path.vertices()) glows += vertex.glow.has_value();
  }
  CHECK(glows > 64);
}

TEST_CASE("light of media that is seen directly is emission, and what they let through is not") {
  Interior ember = grey(0.5f, 0);
  ember.glow.radiance = {1, 2, 3};
  const Scene scene = under(ball_of(Interface{}, ember), constant_sky({1, 1, 1}));
  RenderOptions options = small_picture(4);
  options.light_paths = true;
  const auto check = [&](const Integrator& integrator) {
    const Film film = render_with(scene, integrator, options).film;
    const std::vector<Rgb> parts = parts_at(film, Division::paths, 1, 2);
    const double left = std::exp(-0.5 * 2);
    CHECK(parts[std::size_t(LightPath::emission)].g == Approx(2 * (1 - left)).epsilon(1e-3));
    CHECK(parts[std::size_t(LightPath::environment)].g == Approx(left).epsilon(1e-3));
  };
  check(PathIntegrator(scene, {}));
  check(PathReference(scene, {}));
}

TEST_CASE("light of a medium lights what stands beside it") {
  // A thin glowing ball far above a floor is a point of light: radiance times absorption times volume.
  Scene scene = scene_of(floor_square(30, 0), {0.5f, 0.5f, 0.5f}, {0, 1, 0.01f}, {0, 0, 0});
  scene.camera.tan_half_width = scene.camera.tan_half_height = 1e-3f;
  std::vector<Shape> shapes = scene.geometry->shapes();
  shapes.push_back(SphereSet{"ball", {{{0, 9, 0}, 1}}});
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  scene.materials.push_back({"ember", Interface{}, {}, {.absorption = {1e-3f, 1e-3f, 1e-3f}}});
  scene.materials.back().interior.glow.radiance = {1000, 1000, 1000};
  scene.bindings.push_back({1});
  check_scene(scene);
  const double intensity = 1 * 4.0 / 3 * double(pi), expected = 0.5 / double(pi) * intensity / (9 * 9);
  const Estimate once = estimate(scene, {.max_depth = 1}, small_picture(65536));
  check_mean(once, expected, 0.1);
  // Of the parts of the picture it is direct light of a matte surface, and of a group of its own.
  RenderOptions options = small_picture(64);
  options.light_paths = options.light_groups = true;
  add_light(scene, PointLight{{0, 3, 1}, {1, 1, 1}, {}});
  scene.lights.back().group = 0;
  scene.light_groups = {"lamp", "media"};
  scene.media_group = 1;
  const auto group_at = [&](const Integrator& integrator, const Scene& of, int group) {
    const Film film = render_with(of, integrator, options).film;
    Rgb sum;
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x) {
        sum += parts_at(film, Division::groups, x, y)[std::size_t(group)];
        CHECK(parts_at(film, Division::paths, x, y)[std::size_t(LightPath::diffuse_direct)] ==
              film.pixel(x, y).mean());
      }
    return sum;
  };
  Scene dark = scene;
  dark.lights.clear();
  const PathOptions path{.max_depth = 1};
  const Rgb media = group_at(PathIntegrator(scene, path), scene, 1);
  CHECK(media.r == Approx(group_at(PathIntegrator(dark, path), dark, 1).r).epsilon(1e-4));
  CHECK(media.r > 0);
  CHECK(media == group_at(PathReference(scene, path), scene, 1));
  CHECK(group_at(PathIntegrator(scene, path), scene, 0).r > media.r);
}

TEST_CASE("in a furnace a body that scatters all light is white") {
  for (const SurfaceModel& model : {SurfaceModel(Interface{}), SurfaceModel(Dielectric{.ior = 1.4f})}) {
    const Scene scene = ball_of(model, grey(0, 1));
    CHECK(estimate_of(render_with(scene, FurnaceIntegrator(scene, 100), small_picture(256)).film).mean ==
          Approx(1).epsilon(1e-3));
  }
}

TEST_CASE("light that is scattered once is what the integral along the ray says") {
  for (const float anisotropy : {0.0f, 0.6f, -0.6f}) {
    Interior fog = grey(0.3f, 0.9f);
    fog.anisotropy = anisotropy;
    const Scene scene = under(ball_of(Interface{}, fog), DirectionalLight{{-1, 0, 0}, {1, 1, 1}});
    const double expected = scattered_once(0.3, 0.9, double(PhaseFunction(anisotropy).evaluate(0)));
    check_mean(estimate(scene, {.max_depth = 1}, small_picture(16384)), expected, 0.02);
  }
  // Forward is where the light goes.
  Interior fog = grey(0, 1);
  fog.anisotropy = 0.8f;
  const auto seen = [&](float z) {
    return estimate(under(ball_of(Interface{}, fog), DirectionalLight{{0, 0, z}, {1, 1, 1}}),
                    {.max_depth = 1}, small_picture(256))
        .mean;
  };
  CHECK(seen(1) > 50 * seen(-1));
}

TEST_CASE("light that a medium does not scatter is what it would be if the medium absorbed alone") {
  const Scene scattering = under(ball_of(Interface{}, smoke), constant_sky({1, 1, 1}));
  const Scene absorbing =
      under(ball_of(Interface{}, {.absorption = smoke.extinction()}), constant_sky({1, 1, 1}));
  const PathOptions no_bounce{.max_depth = 0};
  check_same_mean(estimate(scattering, no_bounce, small_picture(16384)),
                  estimate(absorbing, no_bounce, small_picture(16)), 0.03);
}

TEST_CASE("a medium of a density that is the same all around is even") {
  Scene uneven = ball_of(Interface{}, smoke);
  uneven.densities = {grid_of({3, 3, 3}, std::vector<float>(27, 2.0f), 20)};
  uneven.materials[0].interior.density = 0;
  Scene even = ball_of(Interface{}, smoke);
  Interior& dense = even.materials[0].interior;
  dense.absorption = dense.absorption * 2, dense.scattering = dense.scattering * 2;
  const PointLight lamp{{0, 3, 1}, {9, 9, 9}, {}};
  for (const DirectMethod method : {DirectMethod::mis, DirectMethod::lights}) {
    const auto seen = [&](const Scene& scene) {
      return estimate(under(scene, lamp), {.max_depth = 4, .direct = method}, small_picture(4096));
    };
    check_same_mean(seen(uneven), seen(even), 0.06);
  }
  // Where it absorbs alone, nothing is left to chance.
  uneven.materials[0].interior = {.absorption = {0.25f, 0.25f, 0.25f}, .density = 0};
  CHECK(estimate(under(uneven, constant_sky({1, 1, 1})), {}, small_picture(4)).mean ==
        Approx(std::exp(-0.25 * 2 * 2)).epsilon(1e-4));
}

TEST_CASE("a medium is the same in one body and in two that share a face, which no ray sees") {
  Scene whole = under(ball_of(Interface{}, smoke), PointLight{{0, 3, 1}, {9, 9, 9}, {}});
  Scene parted = whole;
  std::vector<Shape> shapes = parted.geometry->shapes();
  shapes.push_back(SphereSet{"inner", {{{0, 0.1f, 0}, 0.6f}}});
  parted.geometry = std::make_shared<const Geometry>(std::move(shapes));
  parted.materials.push_back(parted.materials[0]);
  parted.bindings.push_back({1});
  const PathOptions path{.max_depth = 5};
  check_same_mean(estimate(parted, path, small_picture(8192)), estimate(whole, path, small_picture(8192)),
                  0.05);
}

TEST_CASE("an atmosphere is around the camera and all shapes, but not within what has an inside of its own") {
  Scene scene = scene_of({}, {}, {0, 0, 3}, {0, 0, 0});
  scene.camera.tan_half_width = scene.camera.tan_half_height = 1e-3f;
  add_lamp(scene, SphereSet{"lamp", {{{0, 0, 0}, 1}}}, {1, 1, 1}, EmissionSide::front);
  scene.materials.push_back({.name = "air", .model = Interface{}, .interior = grey(0.25f, 0)});
  scene.atmosphere = std::uint32_t(scene.materials.size() - 1);
  CHECK(estimate(scene, {}, small_picture(4)).mean == Approx(std::exp(-0.5)).epsilon(1e-4));
  // Nothing comes from beyond it.
  Scene sky = scene;
  sky.camera = camera_at({0, 0, 3}, {0, 0, 9});
  add_light(sky, constant_sky({1, 1, 1}));
  CHECK(estimate(sky, {}, small_picture(4)).mean == 0);
  // Nor around a camera in a clear body, but around that.
  std::vector<Shape> shapes = scene.geometry->shapes();
  shapes.push_back(SphereSet{"cabin", {{{0, 0, 3}, 0.5f}}});
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  scene.bindings.push_back({std::uint32_t(scene.materials.size())});
  scene.materials.push_back({.name = "cabin", .model = Interface{}, .interior = {.is_clear = true}});
  CHECK(estimate(scene, {}, small_picture(4)).mean == Approx(std::exp(-0.25 * 1.5)).epsilon(1e-4));
}

TEST_CASE("what media scatter has the same bits on all engines, instruction sets and threads") {
  const Scene scene = scene_of_media();
  check_engines(scene, PathIntegrator(scene, {.max_depth = 3}, "scalar"));
  check_engines(scene, PathIntegrator(scene, {.max_depth = 3}));
  check_engines(scene, FurnaceIntegrator(scene, 5));
}

TEST_CASE("all ways of finding light agree on what media scatter") {
  const Scene scene = scene_of_media();
  const auto seen = [](const Scene& of, DirectMethod method) {
    return estimate(of, {.max_depth = 4, .direct = method}, small_picture(4096));
  };
  check_same_mean(seen(scene, DirectMethod::lights), seen(scene, DirectMethod::mis), 0.2);
  // Which never finds points of light.
  Scene lamps = scene;
  lamps.lights.pop_back();
  check_same_mean(seen(lamps, DirectMethod::hemisphere), seen(lamps, DirectMethod::mis), 0.2);
}

TEST_CASE("where a path is scattered by a medium first, layers have no surface, and the picture is covered") {
  Scene scene = under(ball_of(Interface{}, grey(0.4f, 0.6f)), PointLight{{3, 3, 3}, {9, 9, 9}, {}});
  RenderOptions options = small_picture(4096);
  options.layers = {Layer::alpha, Layer::albedo};
  const Film film = render_with(scene, PathIntegrator(scene, {}), options).film;
  double alpha = 0, albedo = 0;
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) {
      alpha += double(film.value(0, x, y).r) / 16;
      albedo += double(film.value(1, x, y).r) / 16;
    }
  const double scattered = 1 - std::exp(-2.0);
  CHECK(alpha == Approx(scattered).margin(0.01));
  CHECK(albedo == Approx(0.6 * scattered).margin(0.01));
}

TEST_CASE("light that media scatter is transmitted light, and the parts of a picture add up to it") {
  const Scene scene = under(ball_of(Interface{}, smoke), PointLight{{3, 3, 3}, {9, 9, 9}, {}});
  RenderOptions options = small_picture(64);
  options.light_paths = true;
  const Film film = render_with(scene, PathIntegrator(scene, {}), options).film;
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) {
      const std::vector<Rgb> parts = parts_at(film, Division::paths, x, y);
      const Rgb direct = parts[std::size_t(LightPath::transmission_direct)],
                indirect = parts[std::size_t(LightPath::transmission_indirect)];
      CHECK_FALSE(is_black(direct));
      CHECK_FALSE(is_black(indirect));
      CHECK(direct + indirect == film.pixel(x, y).mean());
    }
}

TEST_CASE("how often media scatter is bounded as light that goes through surfaces is") {
  const Scene scene = under(ball_of(Interface{}, white_fog), PointLight{{3, 3, 3}, {9, 9, 9}, {}});
  const Film once = render_with(scene, PathIntegrator(scene, {.max_depth = 1}), small_picture(64)).film;
  const PathOptions limited{.max_depth = 20, .limits = {.transmission = 0}};
  CHECK(same_bits(render_with(scene, PathIntegrator(scene, limited), small_picture(64)).film, once));
}

}  // namespace twinray::test

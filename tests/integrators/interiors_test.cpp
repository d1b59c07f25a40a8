// SPDX-License-Identifier: Apache-2.0
// Light within closed surfaces: what is absorbed on its way, and boundaries of bodies that overlap.
#include <cmath>

#include "accel/accelerator.h"
#include "core/fresnel.h"
#include "integrators/furnace.h"
#include "integrators/path_reference.h"
#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/film.h"
#include "tests/support/film_bytes.h"
#include "tests/support/fog.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

Material body(const SurfaceModel& model, const Interior& interior) {
  Material material{"body", model};
  material.interior = interior;
  return material;
}

EnvironmentLight sky_of(Image map) { return {std::make_shared<const Image>(std::move(map))}; }

/// Spheres around the origin, from the outermost one inward, each of a material; a camera sees their middle.
Scene nested_balls(const std::vector<float>& radii, const std::vector<Material>& materials) {
  Scene scene = scene_of({}, {}, {0, 0, 3}, {0, 0, 0});
  std::vector<Shape> shapes;
  scene.bindings.clear();
  for (std::uint32_t i = 0; i < radii.size(); ++i) {
    shapes.push_back(SphereSet{"ball", {{{0, 0, 0}, radii[i]}}});
    scene.bindings.push_back({i});
  }
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  scene.materials = materials;
  return scene;
}

void add_white_sky(Scene& scene) {
  Image map(1, 1);
  map.pixels[0] = {1, 1, 1};
  add_light(scene, sky_of(std::move(map)));
}

/// One that tells where a ray goes.
void add_colored_sky(Scene& scene) {
  Image map(64, 32);
  for (int i = 0; i < 64 * 32; ++i)
    map.pixels[std::size_t(i)] = {1 + 0.01f * float(i % 64), 2 + 0.02f * float(i / 64), 1};
  add_light(scene, sky_of(std::move(map)));
}

void look_closely(Scene& scene) { scene.camera.tan_half_width = scene.camera.tan_half_height = 1e-4f; }

/// Fog of radius 1 around the origin, before a white sky.
Scene ball_of_fog() {
  Scene scene = nested_balls({1}, {body(Interface{}, {absorption})});
  look_closely(scene);
  add_white_sky(scene);
  return scene;
}

double seen(const Scene& scene, std::uint32_t samples = 4) {
  return estimate(scene, {.max_depth = 20, .roulette = {1}}, small_picture(samples)).mean;
}

}  // namespace

TEST_CASE("what is seen through an interior without a surface is darker by its absorption") {
  Scene scene = nested_balls({1}, {body(Interface{}, {absorption})});
  look_closely(scene);
  add_white_sky(scene);
  CHECK(estimate(scene, {}, small_picture(4)).mean == Approx(left_of(2)).epsilon(render_rounding));
}

TEST_CASE("a camera within a body sees through what that absorbs, however its rays start") {
  Scene scene = ball_of_fog();
  scene.camera.position = {0, 0, 0.5f};
  CHECK(seen(scene) == Approx(left_of(1.5)).epsilon(render_rounding));
  scene.camera.lens_radius = 1e-4f;
  CHECK(seen(scene) == Approx(left_of(1.5)).epsilon(1e-4));
  scene.camera.lens_radius = 0;
  CHECK(estimate_of(render_with(scene, FurnaceIntegrator(scene, 4), small_picture(4)).film).mean ==
        Approx(left_of(1.5)).epsilon(1e-4));
  // All around.
  Scene around = ball_of_fog();
  around.camera = with_panorama(around.camera, Projection::latitude_longitude, 0);
  around.camera.position = {0, 0, 0};
  CHECK(seen(around) == Approx(left_of(1)).epsilon(render_rounding));
  // Clip planes cut off half of the fog.
  Scene cut = ball_of_fog();
  cut.camera.clip_near = 3;
  CHECK(seen(cut) == Approx(left_of(1)).epsilon(render_rounding));
  // Of parallel rays that start on a plane through its middle, some start in the fog.
  Scene parallel = ball_of_fog();
  parallel.camera.position = {0, 0, 0};
  parallel.camera.projection = Projection::orthographic;
  CHECK(seen(parallel) == Approx(left_of(1)).epsilon(render_rounding));
  parallel.camera.frame_center = {1.5f, 0};
  CHECK(seen(parallel) == Approx(1).epsilon(render_rounding));
}

TEST_CASE("a lamp that a camera sees within a body is absorbed, in each part of the light") {
  Scene scene = ball_of_fog();
  scene.camera.position = {0, 0, 0.75f};
  scene.lights.clear();
  add_lamp(scene, SphereSet{"lamp", {{{0, 0, 0}, 0.25f}}}, {1, 1, 1}, EmissionSide::front);
  scene.light_groups = {"lamps", "others"};
  RenderOptions options = small_picture(4);
  options.light_paths = options.light_groups = true;
  const Film waves = render_with(scene, PathIntegrator(scene, {}), options).film;
  CHECK(bytes_of(waves) == bytes_of(render_with(scene, PathReference(scene, {}), options).film));
  const Approx expected = Approx(left_of(0.5)).epsilon(render_rounding);
  CHECK(estimate_of(waves).mean == expected);
  CHECK(luminance(parts_at(waves, Division::paths, 1, 1)[std::size_t(LightPath::emission)]) == expected);
  const std::vector<Rgb> groups = parts_at(waves, Division::groups, 1, 1);
  CHECK(luminance(groups[0]) == expected);
  CHECK(is_black(groups[1]));
}

TEST_CASE("a camera within a body of the shape of instances, or of a mix, sees what that absorbs") {
  Scene scene = ball_of_fog();
  scene.camera.position = {5, 0, 0};
  Scene shown = scene;
  shown.geometry = std::make_shared<const Geometry>(
      scene.geometry->shapes(), nullptr,
      Instancing{{{0, 1}}, {{0, Transform::translation(5, 0, 0)}, {0, Transform::translation(-5, 0, 0)}}});
  CHECK(seen(scene) == 1);
  CHECK(seen(shown) == Approx(left_of(1)).epsilon(render_rounding));
  Scene mixed = ball_of_fog();
  mixed.camera.position = {0, 0, 0};
  mixed.materials = {{"mix", Mix{1, 1, 0.5f}}, mixed.materials[0]};
  CHECK(seen(mixed) == Approx(left_of(1)).epsilon(render_rounding));
}

TEST_CASE("a camera is in no body that is not closed") {
  Mesh box = inward_box(1);
  for (Triangle& triangle : box.triangles) std::swap(triangle[1], triangle[2]);  // fronts outward
  Scene scene = ball_of_fog();
  scene.camera.position = {0, 0, 0};
  const auto within = [&](const Mesh& mesh) {
    scene.geometry = std::make_shared<const Geometry>(std::vector<Shape>{mesh});
    return seen(scene);
  };
  CHECK(within(box) == Approx(left_of(1)).epsilon(render_rounding));
  constexpr int bottom = 4, top = 6;
  for (const int side : {bottom, top}) {
    Mesh open = box;
    open.triangles.erase(open.triangles.begin() + side, open.triangles.begin() + side + 2);
    CHECK(within(open) == 1);
  }
}

TEST_CASE("a camera within nested bodies sees them as their priorities say, by waves and by single paths") {
  const Material glass = body(Refraction{.ior = 1.5f}, {{}, 1});
  const Material water = body(Refraction{.ior = 1.33f}, {absorption, 2});
  Scene nested = nested_balls({1, 0.7f}, {glass, water});
  Scene described = nested_balls(
      {1, 0.7f}, {{"glass", Refraction{.ior = 1.5f}}, body(Refraction{.ior = 1.33f / 1.5f}, {absorption})});
  for (Scene* const scene : {&nested, &described}) {
    scene->camera.tan_half_width = scene->camera.tan_half_height = 0.5f;
    add_colored_sky(*scene);
  }
  for (const float z : {0.85f, 0.3f}) {
    nested.camera.position.z = described.camera.position.z = z;
    CHECK(seen(nested, 64) == Approx(seen(described, 64)).epsilon(1e-4));
    const PathOptions path{.max_depth = 8};
    CHECK(same_bits(render_with(nested, PathIntegrator(nested, path), small_picture(16)).film,
                    render_with(nested, PathReference(nested, path), small_picture(16)).film));
  }
}

TEST_CASE("what is clear within something that absorbs light ends it there") {
  const Interior clear{.is_clear = true};
  for (const SurfaceModel& model : std::vector<SurfaceModel>{Interface{}, Dielectric{.ior = 1.0001f}}) {
    Scene scene = nested_balls({1, 0.5f}, {body(Interface{}, {absorption, 0}), body(model, clear)});
    add_white_sky(scene);
    scene.camera.tan_half_width = scene.camera.tan_half_height = 1e-3f;
    CHECK(seen(scene, 4) == Approx(left_of(1)).epsilon(1e-3));
    scene.camera.position = {0, 0, 0};
    CHECK(seen(scene, 4) == Approx(left_of(0.5)).epsilon(1e-3));
    scene.materials[1].interior.is_clear = false;
    scene.camera.position = {0, 0, 3};
    CHECK(seen(scene, 4) == Approx(left_of(2)).epsilon(1e-3));
  }
}

TEST_CASE("an interface hides no light, and is no vertex of a path") {
  Scene scene =
      nested_balls({1, 0.5f}, {body(Interface{}, {absorption}), body(Interface{}, {.is_clear = true})});
  const Mesh wall{
      .name = "wall", .positions = {{-9, -9, -2}, {9, -9, -2}, {0, 9, -2}}, .triangles = {{0, 1, 2}}};
  std::vector<Shape> shapes = scene.geometry->shapes();
  shapes.push_back(wall);
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  scene.bindings.push_back({2});
  scene.materials.push_back({"wall", Lambert{{0.5f, 0.5f, 0.5f}}});
  look_closely(scene);
  const LightSource lamps[] = {DirectionalLight{{0, 0, -1}, {1, 1, 1}},
                               PointLight{{0, 0, 1.5f}, {3.5f * 3.5f, 3.5f * 3.5f, 3.5f * 3.5f}, {}}};
  for (const LightSource& lamp : lamps) {
    scene.lights = {{"lamp", lamp}};
    // Fog of a length of 1, for the light and for the viewer.
    const PathOptions once{.max_depth = 1};
    CHECK(estimate(scene, once, small_picture(4)).mean == Approx(0.5 / pi * left_of(2)).epsilon(1e-4));
    scene.materials[1].interior = {};
    CHECK(estimate(scene, once, small_picture(4)).mean == Approx(0.5 / pi * left_of(4)).epsilon(1e-4));
    scene.materials[1].interior.is_clear = true;
    for (const DirectMethod method : {DirectMethod::mis, DirectMethod::lights})
      CHECK(same_bits(render_with(scene, PathIntegrator(scene, {.direct = method}), small_picture(4)).film,
                      render_with(scene, PathReference(scene, {.direct = method}), small_picture(4)).film));
  }
  // Light that scattered rays find comes through as well.
  scene.lights.clear();
  add_white_sky(scene);
  const double by_lights =
      estimate(scene, {.max_depth = 1, .direct = DirectMethod::lights}, small_picture(256)).mean;
  for (const DirectMethod method : {DirectMethod::mis, DirectMethod::hemisphere}) {
    CHECK(estimate(scene, {.max_depth = 1, .direct = method}, small_picture(256)).mean ==
          Approx(by_lights).epsilon(0.01));
    CHECK(same_bits(render_with(scene, PathIntegrator(scene, {.direct = method}), small_picture(4)).film,
                    render_with(scene, PathReference(scene, {.direct = method}), small_picture(4)).film));
  }
}

TEST_CASE("a plate of absorbing glass reflects and lets through what the sum of its reflections says") {
  Scene scene = scene_of(inward_box(0.25f), {}, {0, 0, 3}, {0, 0, 0});
  Mesh plate = inward_box(0.25f);
  for (Triangle& triangle : plate.triangles) std::swap(triangle[1], triangle[2]);  // fronts outward
  for (Vec3& p : plate.positions) p.x *= 8, p.y *= 8;
  scene.geometry = std::make_shared<const Geometry>(std::vector<Shape>{std::move(plate)});
  scene.materials = {body(Dielectric{1.5f}, {absorption})};
  look_closely(scene);
  add_white_sky(scene);
  const double once = fresnel_dielectric(1, 1.5f);
  double expected = 0;
  const double weights[] = {0.2126, 0.7152, 0.0722}, sigma[] = {0.5, 1, 2};
  for (int c = 0; c < 3; ++c) {
    const double way = std::exp(-sigma[c] * 0.5), within = 1 - once * once * way * way;
    const double through = (1 - once) * (1 - once) * way / within;
    expected += weights[c] * (through + once + through * once * way);
  }
  check_mean(estimate(scene, {.max_depth = 100, .roulette = {1}}, small_picture(4096)), expected, 0.02);
}

TEST_CASE("light samples fade on their way through the interior that a surface stands in") {
  // A floor in fog that begins 2 above it; a point light 1 above it.
  Scene scene = scene_of(floor_square(0.5f, 0), {1, 1, 1}, {0, 5, 0}, {0, 0, 0});
  std::vector<Shape> shapes = scene.geometry->shapes();
  shapes.push_back(SphereSet{"fog", {{{0, 0, 0}, 2}}});
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  scene.materials.push_back(body(Interface{}, {absorption}));
  scene.bindings.push_back({1});
  look_closely(scene);
  Scene lit = scene;
  add_light(lit, PointLight{{0, 1, 0}, {1, 1, 1}, {}});
  for (const DirectMethod method : {DirectMethod::mis, DirectMethod::lights})
    CHECK(estimate(lit, {.max_depth = 2, .direct = method}, small_picture(4)).mean ==
          Approx(left_of(1 + 2) / 3.14159265).epsilon(1e-4));
  // By every method, of a lamp that is not small.
  add_lamp(scene, SphereSet{"lamp", {{{0, 1, 0.3f}, 0.4f}}}, {4, 4, 4}, EmissionSide::front);
  const auto found = [&](DirectMethod method) {
    return estimate(scene, {.max_depth = 2, .direct = method}, small_picture(20000));
  };
  const Estimate expected = found(DirectMethod::mis);
  check_same_mean(found(DirectMethod::lights), expected, 0.05);
  check_same_mean(found(DirectMethod::hemisphere), expected, 0.05);
}

TEST_CASE("rough surfaces see lights through interiors alike by every method") {
  Scene scene = nested_balls({1}, {body(Dielectric{1.4f, {0.5f, 0.5f}}, {absorption})});
  scene.camera.tan_half_width = scene.camera.tan_half_height = 0.1f;
  add_lamp(scene, SphereSet{"lamp", {{{0, 0.2f, 0}, 0.5f}}}, {4, 4, 4}, EmissionSide::front);
  const auto found = [&](DirectMethod method) {
    return estimate(scene, {.max_depth = 1, .direct = method, .roulette = {1}}, small_picture(40000));
  };
  const Estimate expected = found(DirectMethod::mis);
  check_same_mean(found(DirectMethod::lights), expected, 0.1);
  check_same_mean(found(DirectMethod::hemisphere), expected, 0.1);
}

TEST_CASE("a body of a mix is left by whatever part it was entered") {
  const Interior tea{{0.5f, 1, 2}, 0};
  const Dielectric water{1.33f};
  const auto mean = [](const std::vector<Material>& materials) {
    Scene scene = nested_balls({1}, materials);
    add_white_sky(scene);
    scene.camera.tan_half_width = scene.camera.tan_half_height = 0.2f;
    return estimate(scene, {.max_depth = 30}, small_picture(64)).mean;
  };
  const std::vector<Material> pure{body(water, tea)};
  const std::vector<Material> mixed{{"mix", Mix{1, 2, 0.5f}}, body(water, tea), body(water, tea)};
  const std::vector<Material> twice{{"mix", Mix{1, 2, 0.5f}},
                                    body(water, tea),
                                    {"mix", Mix{3, 4, 0.5f}},
                                    body(water, tea),
                                    body(water, tea)};
  CHECK(mean(mixed) == mean(pure));
  CHECK(mean(twice) == mean(pure));
}

TEST_CASE("bodies one within the other are the boundaries that their priorities say") {
  // Water in glass, by indices to the vacuum and priorities, and by the index of water to glass.
  Scene nested = nested_balls(
      {1, 0.7f}, {body(Refraction{.ior = 1.5f}, {{}, 1}), body(Refraction{.ior = 1.33f}, {absorption, 2})});
  Scene described = nested_balls(
      {1, 0.7f}, {{"glass", Refraction{.ior = 1.5f}}, body(Refraction{.ior = 1.33f / 1.5f}, {absorption})});
  Scene alone = nested_balls({1}, {{"glass", Refraction{.ior = 1.5f}}});
  for (Scene* const scene : {&nested, &described, &alone}) {
    scene->camera.tan_half_width = scene->camera.tan_half_height = 0.1f;
    add_colored_sky(*scene);
  }
  const auto mean = [](const Scene& scene) {
    return estimate(scene, {.max_depth = 20, .roulette = {1}}, small_picture(64)).mean;
  };
  CHECK(mean(nested) == Approx(mean(described)).epsilon(1e-4));
  CHECK(mean(nested) < 0.7 * mean(alone));
  // Of a lower priority, the inner body is not there, nor what it would absorb.
  nested.materials[0].interior.priority = 3;
  CHECK(mean(nested) == Approx(mean(alone)).epsilon(1e-4));
}

TEST_CASE("two bodies of one index that overlap show no boundary between them") {
  Scene scene = nested_balls({1, 1}, {body(Glass{.ior = 1.5f}, {{}, 1}), body(Glass{.ior = 1.5f}, {{}, 2})});
  std::vector<Shape> shapes = scene.geometry->shapes();
  std::get<SphereSet>(shapes[1]).spheres[0].center = {0, 0, -1};
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  look_closely(scene);
  add_white_sky(scene);
  // The camera looks along both centres: two boundaries reflect, at the front and at the back.
  Scene black = scene;
  black.lights[0].source = AmbientLight{{0, 0, 1}, {1, 1, 1}};
  const double once = fresnel_dielectric(1, 1.5f);
  const auto reflected = estimate(black, {.max_depth = 100, .roulette = {1}}, small_picture(4096));
  check_mean(reflected, once + (1 - once) * (1 - once) * once / (1 - once * once), 0.1);
}

}  // namespace twinray::test

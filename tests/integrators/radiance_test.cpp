// SPDX-License-Identifier: Apache-2.0
// Scenes whose radiance is known in closed form, for every light and both ways of sampling direct light.
#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

constexpr float reflectance = 0.6f;

/// A floor seen in a single point, the origin, so that one radiance is that of the whole picture.
Scene floor_scene() {
  Mesh floor;  // one large triangle: the point we look at lies far from all edges
  floor.positions = {{-200, 0, 100}, {200, 0, 100}, {0, 0, -200}};
  floor.triangles = {{0, 1, 2}};
  Scene scene = scene_of(floor, {reflectance, reflectance, reflectance}, {0.5f, 1, 0.75f}, {0, 0, 0});
  scene.camera.tan_half_width = scene.camera.tan_half_height = 1e-5f;
  return scene;
}

/// Of direct light. An error of 5 % would be seen, whatever the light and the method.

void check_radiance(const Scene& scene, double expected, DirectMethod method) {
  const RenderOptions render = small_picture(method == DirectMethod::hemisphere ? 20000 : 4096);
  check_mean(estimate(scene, {.max_depth = 1, .direct = method}, render), expected, 0.05);
}

/// Form factor of a small floor element and a parallel square of half-width a centred at height h above it.
double square_form_factor(double a, double h) {
  const double x = a / h, s = std::sqrt(1 + x * x);
  return 4 / (2 * M_PI) * 2 * (x / s) * std::atan(x / s);
}

constexpr float emitted = 0.5f, albedo = 0.5f;

/// A ball seen from inside, whose wall emits and reflects. By light sampling a box will not do: near its
/// edges the estimate's variance has no bound, so that no z-test holds. In a ball cos cos / d^2 is nearly
/// constant.
Scene emissive_ball() {
  Scene scene = scene_of(icosphere(2), {albedo, albedo, albedo}, {0.2f, 0.1f, 0.3f}, {-0.5f, -0.4f, -1});
  scene.bindings[0].light = 0;
  scene.lights.push_back({"wall", MeshLight{0, {emitted, emitted, emitted}, EmissionSide::both}});
  return scene;
}

}  // namespace

TEST_CASE("a point light lights a floor by its intensity, the cosine and the square of the distance") {
  Scene scene = floor_scene();
  add_light(scene, PointLight{{0, 3, 4}, {10, 10, 10}, {}});
  check_radiance(scene, reflectance / M_PI * 10 * 0.6 / 25, DirectMethod::lights);
}

TEST_CASE("a point light's own attenuation replaces the law of squares") {
  Scene scene = floor_scene();
  add_light(scene, PointLight{{0, 3, 4}, {10, 10, 10}, {2, 0.5f, 0.1f}});
  check_radiance(scene, reflectance / M_PI * 10 * 0.6 / (2 + 0.5 * 5 + 0.1 * 25), DirectMethod::lights);
}

TEST_CASE("a spot light lights within its cone by its falloff and not outside of it") {
  SpotLight spot;
  spot.position = {0, 3, 4};
  spot.intensity = {10, 10, 10};
  spot.falloff_exponent = 2;
  spot.direction = normalize(Vec3{0, -3, -3});
  const double cosine = (3 * 3 + 3 * 4) / (std::sqrt(18.0) * 5);
  SECTION("inside") {
    spot.falloff_angle_degrees = 40;
    Scene scene = floor_scene();
    add_light(scene, spot);
    check_radiance(scene, reflectance / M_PI * 10 * 0.6 / 25 * cosine * cosine, DirectMethod::lights);
  }
  SECTION("outside") {
    spot.falloff_angle_degrees = 10;
    Scene scene = floor_scene();
    add_light(scene, spot);
    CHECK(estimate(scene, {.max_depth = 1}, small_picture(16)).mean == 0);
  }
}

TEST_CASE("a directional light lights a floor by its irradiance and the cosine") {
  Scene scene = floor_scene();
  add_light(scene, DirectionalLight{normalize(Vec3{1, -2, 2}), {3, 3, 3}});
  check_radiance(scene, reflectance / M_PI * 3 * (2.0 / 3), DirectMethod::lights);
}

TEST_CASE("an ambient light lights a floor under its hemisphere by its radiance times the reflectance") {
  for (const DirectMethod method : all_methods) {
    Scene scene = floor_scene();
    add_light(scene, AmbientLight{{0, 1, 0}, {2, 2, 2}});
    check_radiance(scene, reflectance * 2, method);
    scene.camera = camera_at({0, 1, 0}, {0, 2, 0.5f});
    CHECK(estimate(scene, {.max_depth = 0}, small_picture(1)).mean == 0);  // the camera does not see it
  }
}

TEST_CASE("a uniform environment lights a floor by its radiance times the reflectance, and fills the sky") {
  for (const DirectMethod method : all_methods) {
    Scene scene = floor_scene();
    auto map = std::make_shared<Image>(8, 4);
    for (Rgb& pixel : map->pixels) pixel = {2, 2, 2};
    add_light(scene, EnvironmentLight{map});
    check_radiance(scene, reflectance * 2, method);
    // What leaves a floor has no second bounce, so that a greater depth adds nothing.
    check_mean(estimate(scene, {.max_depth = 3, .direct = method}, small_picture(20000)), reflectance * 2,
               0.05);
    scene.camera = camera_at({0, 1, 0}, {0, 2, 0.5f});
    CHECK(estimate(scene, {.max_depth = 0}, small_picture(1)).mean == Approx(2).epsilon(render_rounding));
  }
}

TEST_CASE("a sun lights a floor by its irradiance and the cosine, by every way of sampling, and is seen") {
  for (const DirectMethod method : all_methods) {
    Scene scene = floor_scene();
    const Vec3 towards = normalize(Vec3{1, 2, 2});
    add_light(scene, SunLight{-towards, {3, 3, 3}, 60});
    check_radiance(scene, reflectance / M_PI * 3 * (2.0 / 3), method);
    scene.camera = camera_at({0, 1, 0}, Vec3{0, 1, 0} + towards);
    CHECK(estimate(scene, {.max_depth = 0}, small_picture(1)).mean ==
          Approx(3 / (M_PI / 4)).epsilon(render_rounding));
  }
}

TEST_CASE("an environment of two halves lights a floor as emissive walls around all of it do") {
  // Bright where x > 0, dim elsewhere: columns from -z over +x to +z are the middle half.
  auto map = std::make_shared<Image>(64, 32);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x) map->at(x, y) = x >= 16 && x < 48 ? Rgb{3, 3, 3} : Rgb{1, 1, 1};
  Scene under_walls = floor_scene(), under_sky = floor_scene();
  const auto add_half = [&](float x, float radiance) {
    Mesh box = inward_box(20);
    for (Vec3& p : box.positions) p.x = p.x * x > 0 ? p.x : 0;
    // The wall at x = 0 has a front, and is dropped: it would part the room.
    std::erase_if(box.triangles, [&](const Triangle& t) {
      return box.positions[t[0]].x == 0 && box.positions[t[1]].x == 0 && box.positions[t[2]].x == 0;
    });
    add_lamp(under_walls, std::move(box), {radiance, radiance, radiance}, EmissionSide::front);
  };
  add_half(1, 3);
  add_half(-1, 1);
  add_light(under_sky, EnvironmentLight{map});
  // Seen from the middle of the floor, half of the cosine-weighted hemisphere is bright; a soft seam in both.
  check_mean(estimate(under_walls, {.max_depth = 1}, small_picture(20000)), reflectance * 2, 0.05);
  check_mean(estimate(under_sky, {.max_depth = 1}, small_picture(20000)), reflectance * 2, 0.05);
}

TEST_CASE("one of many lights chosen by a tree or by power has the mean of all of them") {
  Scene scene = floor_scene();
  Random random(2);
  for (int i = 0; i < 30; ++i) {
    const Vec3 place = Vec3{0, 2.5f, 0} + random.in_ball() * 2;
    Mesh lamp = floor_square(0.2f, 0);
    for (Vec3& p : lamp.positions) p = p + place;
    add_lamp(scene, std::move(lamp), {1, 2, 3}, i % 3 ? EmissionSide::back : EmissionSide::both);
    add_light(scene, PointLight{random.in_ball() + Vec3{0, 2, 0}, {0.05f, 0.05f, 0.05f}, {}});
  }
  const auto by = [&](ManyLights many, DirectMethod method, std::uint32_t samples) {
    return estimate(scene, {.max_depth = 1, .direct = method, .many_lights = many}, small_picture(samples));
  };
  const Estimate all = by(ManyLights::all, DirectMethod::lights, 256);
  for (const DirectMethod method : {DirectMethod::mis, DirectMethod::lights}) {
    const Estimate by_tree = by(ManyLights::tree, method, 8192),
                   by_power = by(ManyLights::power, method, 8192);
    check_same_mean(all, by_tree, 0.05);
    check_same_mean(all, by_power, 0.1);
    CHECK(by_tree.standard_error < by_power.standard_error);
  }
}

TEST_CASE("one of many lights has the mean of all of them behind a surface that lets light through, too") {
  Scene scene = floor_scene();
  scene.materials[0].model = DiffuseTransmission{{0.2f, 0.2f, 0.2f}, {0.6f, 0.6f, 0.6f}};
  Random random(3);
  for (int i = 0; i < 30; ++i) {
    const Vec3 place = Vec3{0, i % 2 ? -2.5f : 2.5f, 0} + random.in_ball() * 2;
    Mesh lamp = floor_square(0.2f, 0);
    for (Vec3& p : lamp.positions) p = p + place;
    add_lamp(scene, std::move(lamp), {1, 2, 3}, EmissionSide::both);
  }
  const auto by = [&](ManyLights many, std::uint32_t samples) {
    return estimate(scene, {.max_depth = 1, .direct = DirectMethod::lights, .many_lights = many},
                    small_picture(samples));
  };
  check_same_mean(by(ManyLights::all, 256), by(ManyLights::tree, 8192), 0.05);
}

TEST_CASE("a floor has the reflectance of its texture where it is seen") {
  auto picture = Image(2, 2);
  picture.pixels = {{0.1f, 0.1f, 0.1f}, {0.3f, 0.3f, 0.3f}, {0.9f, 0.9f, 0.9f}, {0.7f, 0.7f, 0.7f}};
  for (const DirectMethod method : all_methods) {
    Scene scene = floor_scene();
    add_light(scene, AmbientLight{{0, 1, 0}, {2, 2, 2}});
    // The floor is seen where its coordinates are (1/3, 1/3): these become (0.43, 0.33), lower left.
    scene.textures = {{"", ImageTexture{std::make_shared<const MipMap>(picture),
                                        WrapMode::repeat,
                                        TextureFilter::nearest,
                                        {{{1, 0, 0.1f}, {0, 1, 0}}}}}};
    scene.materials[0].textures = {{MaterialInput::reflectance, 0}};
    check_radiance(scene, 0.9 * 2, method);
  }
}

TEST_CASE("a square light lights a floor by its form factor, from its emitting side only") {
  for (const DirectMethod method : all_methods) {
    for (const EmissionSide side : {EmissionSide::front, EmissionSide::back, EmissionSide::both}) {
      Scene scene = floor_scene();
      add_lamp(scene, floor_square(2, 3), {5, 5, 5}, side);  // its front faces up, away from the floor
      if (side == EmissionSide::front)
        CHECK(estimate(scene, {.max_depth = 1, .direct = method}, small_picture(64)).mean == 0);
      else
        check_radiance(scene, reflectance * 5 * square_form_factor(2, 3), method);
    }
  }
}

namespace {

/// A lamp in the plane y = 3 over [x0, x1] x [-2, 2], whose texture coordinates run from (0, 0) to (1, 1).
Mesh lamp_over(float x0, float x1) {
  Mesh lamp;
  lamp.positions = {{x0, 3, -2}, {x1, 3, -2}, {x1, 3, 2}, {x0, 3, 2}};
  lamp.triangles = lamp.uv_indices = {{0, 1, 2}, {0, 2, 3}};
  lamp.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  return lamp;
}

/// So many pixels that what is mixed between the halves is little.
std::shared_ptr<const Image> two_halves(const Rgb& left, const Rgb& right) {
  auto image = std::make_shared<Image>(2048, 1);
  for (int x = 0; x < 2048; ++x) image->at(x, 0) = x < 1024 ? left : right;
  return image;
}

}  // namespace

TEST_CASE("a lamp with a picture of two halves is two lamps, by every way of finding direct light") {
  for (const DirectMethod method : all_methods)
    for (const EmissionSide side : {EmissionSide::front, EmissionSide::back, EmissionSide::both}) {
      const RenderOptions render = small_picture(method == DirectMethod::hemisphere ? 40000 : 20000);
      Scene one = floor_scene(), two = floor_scene();
      add_lamp(one, lamp_over(-0.5f, 3.5f), {5, 5, 5}, side);
      std::get<MeshLight>(one.lights[0].source).picture = two_halves({}, {1, 0.8f, 0.6f});
      add_lamp(two, lamp_over(1.5f, 3.5f), {5, 4, 3}, side);
      add_lamp(two, lamp_over(-0.5f, 1.5f), {}, side);
      const Estimate pictured = estimate(one, {.max_depth = 1, .direct = method}, render);
      const Estimate halves = estimate(two, {.max_depth = 1, .direct = method}, render);
      if (side == EmissionSide::back)
        CHECK(pictured.mean == 0);
      else
        check_same_mean(pictured, halves, 0.05);
    }
}

TEST_CASE("the picture of a lamp is seen, from the sides that emit") {
  Scene scene = floor_scene();
  add_lamp(scene, lamp_over(-2, 2), {5, 5, 5}, EmissionSide::front);
  auto image = std::make_shared<Image>(2, 2);
  image->pixels = {{0.1f, 0.1f, 0.1f}, {0.2f, 0.2f, 0.2f}, {0.3f, 0.3f, 0.3f}, {0.4f, 0.4f, 0.4f}};
  std::get<MeshLight>(scene.lights[0].source).picture = image;
  const auto seen = [&](float x, float z) {
    scene.camera = camera_at({x, 1, z}, {x, 3, z});
    scene.camera.tan_half_width = scene.camera.tan_half_height = 1e-5f;
    return estimate(scene, {.max_depth = 0}, small_picture(1)).mean;
  };
  // v runs upwards: the lower row of the picture is at z = -1.
  CHECK(seen(-1, -1) == Approx(5 * 0.3).epsilon(1e-4));
  CHECK(seen(1, -1) == Approx(5 * 0.4).epsilon(1e-4));
  CHECK(seen(1, 1) == Approx(5 * 0.2).epsilon(1e-4));
  // Twice as often along u, and upside down, with an edge between texels at z = 0.
  auto& light = std::get<MeshLight>(scene.lights[0].source);
  light.uv = {{{2, 0, 0}, {0, -1, 1}}}, light.wrap = WrapMode::repeat, light.filter = TextureFilter::nearest;
  CHECK(seen(-1.5f, -0.1f) == Approx(5 * 0.1).epsilon(1e-4));
  CHECK(seen(-0.5f, -0.1f) == Approx(5 * 0.2).epsilon(1e-4));
  CHECK(seen(0.5f, 0.1f) == Approx(5 * 0.3).epsilon(1e-4));
  light.wrap = WrapMode::clamp;
  CHECK(seen(0.5f, 0.1f) == Approx(5 * 0.4).epsilon(1e-4));
  light.side = EmissionSide::back;
  CHECK(seen(1, 1) == 0);
}

TEST_CASE("a square light close to a floor lights it by its form factor, by mis with a third of the noise") {
  Scene scene = floor_scene();
  scene.camera = camera_at({0, 0.2f, 0}, {0, 0, 0.01f});
  add_lamp(scene, floor_square(2, 0.3f), {5, 5, 5}, EmissionSide::both);
  const double expected = reflectance * 5 * square_form_factor(2, 0.3);
  const Estimate by_both = estimate(scene, {.max_depth = 1}, small_picture(4096));
  const Estimate by_lights =
      estimate(scene, {.max_depth = 1, .direct = DirectMethod::lights}, small_picture(4096));
  check_mean(by_both, expected, 0.02);
  check_mean(estimate(scene, {.max_depth = 1, .samples_per_light = 4}, small_picture(4096)), expected, 0.02);
  CHECK(by_both.standard_error < by_lights.standard_error / 3);
}

TEST_CASE("a lamp under a ceiling that it lights has the mean of hemisphere sampling by mis") {
  Scene scene = small_room();
  std::get<MeshLight>(scene.lights.at(0).source).side = EmissionSide::both;
  const PathOptions by_directions{.max_depth = 3, .direct = DirectMethod::hemisphere};
  const PathOptions by_lights{.max_depth = 3, .direct = DirectMethod::lights};
  const Estimate by_both = estimate(scene, {.max_depth = 3}, small_picture(512));
  check_same_mean(by_both, estimate(scene, by_directions, small_picture(4096)), 0.2);
  CHECK(by_both.standard_error < 0.5 * estimate(scene, by_lights, small_picture(512)).standard_error);
}

TEST_CASE("a sphere light overhead lights a floor by (r / d)^2") {
  for (const DirectMethod method : all_methods) {
    Scene scene = floor_scene();
    add_lamp(scene, SphereSet{"lamp", {{{0, 4, 0}, 1.5f}}}, {5, 5, 5}, EmissionSide::both);
    check_radiance(scene, reflectance * 5 * (1.5 * 1.5) / 16, method);
  }
}

TEST_CASE("lights of every kind add up, and more samples of each keep the mean") {
  Scene scene = floor_scene();
  const double lamp = square_form_factor(2, 3);
  add_lamp(scene, floor_square(2, 3), {5, 5, 5}, EmissionSide::back);
  add_light(scene, AmbientLight{{0, 1, 0}, {2, 2, 2}});  // the lamp stands in front of a part of it
  const double extended = reflectance * (5 * lamp + 2 * (1 - lamp));
  add_light(scene, DirectionalLight{normalize(Vec3{1, -2, 2}), {3, 3, 3}});
  add_light(scene, PointLight{{0, 1, 0}, {0.5f, 0.5f, 0.5f}, {}});
  const double delta = reflectance / M_PI * (3 * (2.0 / 3) + 0.5);
  for (const std::uint32_t samples : {1u, 16u}) {
    const PathOptions by_lights{.max_depth = 1, .samples_per_light = samples};
    check_mean(estimate(scene, by_lights, small_picture(8192 / samples)), extended + delta, 0.02);
    const PathOptions by_directions{
        .max_depth = 1, .direct = DirectMethod::hemisphere, .samples_per_light = samples};
    check_mean(estimate(scene, by_directions, small_picture(8192 / samples)), extended, 0.02);
  }
}

TEST_CASE("inside of walls that emit and reflect, radiance is the geometric series of all bounces") {
  const auto check = [](const Scene& scene, const PathOptions& path, const RenderOptions& render,
                        Backend backend, double sees) {
    INFO(backend_name(backend) << ", depth " << path.max_depth);
    const double exact = emitted * (1 - std::pow(albedo, path.max_depth + 1)) / (1 - albedo);
    check_mean(estimate(scene, path, render, backend), exact, sees);
  };
  const Scene box = emissive_enclosure(emitted, albedo), ball = emissive_ball();
  for (const int depth : {0, 1, 2, 5, 30}) {
    const PathOptions by_directions{.max_depth = depth, .direct = DirectMethod::hemisphere};
    check(box, by_directions, small_picture(2048), default_backend(), 0.02);
    check(ball, {.max_depth = depth}, small_picture(1024), default_backend(), 0.02);
  }
  // A gross error would be seen with any engine and sampler; small ones are, by the bits of pictures.
  for (const Backend backend : available_backends())
    for (const SamplerKind sampler : {SamplerKind::independent, SamplerKind::sobol}) {
      RenderOptions few = small_picture(64);
      few.sampler = sampler;
      for (const int depth : {0, 5}) check(ball, {.max_depth = depth}, few, backend, 0.1);
    }
}

TEST_CASE("a white convex body in a furnace vanishes") {
  Scene scene = scene_of(icosphere(2), {1, 1, 1}, {0, 0, 3}, {0, 0, 0});
  add_lamp(scene, inward_box(4), {2, 2, 2}, EmissionSide::both);
  for (const DirectMethod method : all_methods) {
    const Estimate found = estimate(scene, {.max_depth = 6, .direct = method}, small_picture(2048));
    check_mean(found, 2, method == DirectMethod::lights ? 0.07 : 0.02);
  }
}

}  // namespace twinray::test

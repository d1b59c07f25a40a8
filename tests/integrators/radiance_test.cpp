// SPDX-License-Identifier: Apache-2.0
// Scenes whose radiance is known in closed form, for every light and both ways of sampling direct light.
#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

constexpr float reflectance = 0.6f;
/// Rounding of a float estimate, for light without any variance; beyond it a z-test decides.
constexpr double rounding = 1e-5;

/// A floor seen in a single point, the origin, so that one radiance is that of the whole picture.
Scene floor_scene() {
  Mesh floor;  // one large triangle: the point we look at lies far from all edges
  floor.positions = {{-200, 0, 100}, {200, 0, 100}, {0, 0, -200}};
  floor.triangles = {{0, 1, 2}};
  Scene scene = scene_of(floor, {reflectance, reflectance, reflectance}, {0.5f, 1, 0.75f}, {0, 0, 0});
  scene.camera.tan_half_width = scene.camera.tan_half_height = 1e-5f;
  return scene;
}

RenderOptions options(std::uint32_t samples) {
  return {.width = 4,
          .height = 4,
          .samples = samples,
          .sampler = SamplerKind::independent,
          .seed = 7,
          .threads = 1};
}

void check_radiance(const Scene& scene, double expected, DirectMethod method) {
  PathOptions path;
  path.max_depth = 1;
  path.direct = method;
  const Estimate found = estimate(scene, path, options(4096));
  INFO("mean " << found.mean << " +- " << found.standard_error << ", expected " << expected);
  CHECK((std::fabs(found.mean - expected) <= rounding * expected || z_score(found, expected) <= z_limit));
}

/// Form factor of a small floor element and a parallel square of half-width a centred at height h above it.
double square_form_factor(double a, double h) {
  const double x = a / h, s = std::sqrt(1 + x * x);
  return 4 / (2 * M_PI) * 2 * (x / s) * std::atan(x / s);
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
    CHECK(estimate(scene, {.max_depth = 1}, options(16)).mean == 0);
  }
}

TEST_CASE("a directional light lights a floor by its irradiance and the cosine") {
  Scene scene = floor_scene();
  add_light(scene, DirectionalLight{normalize(Vec3{1, -2, 2}), {3, 3, 3}});
  check_radiance(scene, reflectance / M_PI * 3 * (2.0 / 3), DirectMethod::lights);
}

TEST_CASE("an ambient light lights a floor under its hemisphere by its radiance times the reflectance") {
  for (const DirectMethod method : {DirectMethod::lights, DirectMethod::hemisphere}) {
    Scene scene = floor_scene();
    add_light(scene, AmbientLight{{0, 1, 0}, {2, 2, 2}});
    check_radiance(scene, reflectance * 2, method);
  }
}

TEST_CASE("a uniform environment lights a floor by its radiance times the reflectance, and fills the sky") {
  for (const DirectMethod method : {DirectMethod::lights, DirectMethod::hemisphere}) {
    Scene scene = floor_scene();
    auto map = std::make_shared<Image>(8, 4);
    for (Rgb& pixel : map->pixels) pixel = {2, 2, 2};
    add_light(scene, EnvironmentLight{map});
    check_radiance(scene, reflectance * 2, method);
    scene.camera = camera_at({0, 1, 0}, {0, 2, 0.5f});
    CHECK(estimate(scene, {.max_depth = 0}, options(1)).mean == Approx(2).epsilon(rounding));
  }
}

TEST_CASE("a square lamp lights a floor by its form factor, from its emitting side only") {
  for (const DirectMethod method : {DirectMethod::lights, DirectMethod::hemisphere}) {
    for (const EmissionSide side : {EmissionSide::front, EmissionSide::back, EmissionSide::both}) {
      Scene scene = floor_scene();
      add_lamp(scene, floor_square(2, 3), {5, 5, 5}, side);  // its front faces up, away from the floor
      if (side == EmissionSide::front)
        CHECK(estimate(scene, {.max_depth = 1, .direct = method}, options(64)).mean == 0);
      else
        check_radiance(scene, reflectance * 5 * square_form_factor(2, 3), method);
    }
  }
}

TEST_CASE("a sphere lamp overhead lights a floor by (r / d)^2") {
  for (const DirectMethod method : {DirectMethod::lights, DirectMethod::hemisphere}) {
    Scene scene = floor_scene();
    add_lamp(scene, SphereSet{"lamp", {{{0, 4, 0}, 1.5f}}}, {5, 5, 5}, EmissionSide::both);
    check_radiance(scene, reflectance * 5 * (1.5 * 1.5) / 16, method);
  }
}

TEST_CASE("several lights add up, and more samples of each keep the mean") {
  Scene scene = floor_scene();
  add_lamp(scene, floor_square(2, 3), {5, 5, 5}, EmissionSide::back);
  add_light(scene, DirectionalLight{{0, -1, 0}, {0, 0, 0}});
  add_light(scene, AmbientLight{{0, 1, 0}, {0, 0, 0}});
  PathOptions path{.max_depth = 1, .samples_per_light = 16};
  const Estimate found = estimate(scene, path, options(512));
  CHECK(z_score(found, reflectance * 5 * square_form_factor(2, 3)) <= z_limit);
}

TEST_CASE("inside of walls that emit and reflect, radiance is the geometric series of all bounces") {
  const float emitted = 0.5f, albedo = 0.5f;
  const Scene scene = emissive_enclosure(emitted, albedo);
  for (const Backend backend : available_backends())
    for (const SamplerKind sampler : {SamplerKind::independent, SamplerKind::sobol})
      for (const DirectMethod method : {DirectMethod::lights, DirectMethod::hemisphere})
        for (const int depth : {0, 1, 2, 5, 30}) {
          RenderOptions render_options = options(64);
          render_options.sampler = sampler;
          const Estimate found =
              estimate(scene, {.max_depth = depth, .direct = method}, render_options, backend);
          const double exact = emitted * (1 - std::pow(albedo, depth + 1)) / (1 - albedo);
          INFO(backend_name(backend) << ", depth " << depth << ": " << found.mean << " +- "
                                     << found.standard_error << ", exact " << exact);
          CHECK((std::fabs(found.mean - exact) <= rounding * exact || z_score(found, exact) <= z_limit));
        }
}

TEST_CASE("a white convex body in a furnace vanishes") {
  Scene scene = scene_of(icosphere(2), {1, 1, 1}, {0, 0, 3}, {0, 0, 0});
  add_lamp(scene, inward_box(4), {2, 2, 2}, EmissionSide::both);
  for (const DirectMethod method : {DirectMethod::lights, DirectMethod::hemisphere}) {
    const Estimate found = estimate(scene, {.max_depth = 6, .direct = method}, options(256));
    CHECK(z_score(found, 2) <= z_limit);
  }
}

}  // namespace twinray::test

// SPDX-License-Identifier: Apache-2.0
#include "core/light_set.h"

#include <algorithm>
#include <cmath>

#include "accel/accelerator.h"
#include "core/environment.h"
#include "core/warp.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"
#include "tests/support/statistics.h"

namespace twinray::test {
namespace {

/// Densities are products and quotients of a few floats.
constexpr double of_few_floats = 1e-4;

SurfacePoint below() {
  SurfacePoint point;
  point.position = {0.2f, -1, 0.3f};
  point.geometric_normal = point.shading_normal = {0, 1, 0};
  return point;
}

Receiver receiver() { return {below().position, below().shading_normal}; }

Scene scene_with(Shape lamp) {
  Scene scene = scene_of(floor_square(5, -1), {0.5f, 0.5f, 0.5f}, {0, 1, 5}, {0, 0, 0});
  add_lamp(scene, std::move(lamp), {3, 2, 1}, EmissionSide::both);
  return scene;
}

/// 1 / density averaged over samples is the solid angle of what is sampled.
SampleMean inverse_density(const Scene& scene, int seed) {
  const LightSet lights(scene);
  Random random{std::uint64_t(seed)};
  SampleMean mean;
  for (int i = 0; i < 100000; ++i) {
    const LightSample sample = lights.sample(0, below(), receiver(), in_square(random));
    if (!is_black(sample.radiance)) mean.add(1 / double(sample.pdf));
  }
  return mean;
}

}  // namespace

TEST_CASE("draws that choose from groups of lights have bits below their 24, other ones for each") {
  Random random(3);
  std::vector<float> found;
  for (int i = 0; i < 1000; ++i) {
    const Vec2 u{random.unit(), random.unit()};
    found.push_back(LightSet::finer_bits(u));
    CHECK(found.back() >= 0);
    CHECK(found.back() < 0x1p-24f);
    CHECK(LightSet::finer_bits(u) == found.back());
  }
  std::sort(found.begin(), found.end());
  for (std::size_t i = 0; i < found.size(); ++i)
    CHECK(std::fabs(double(found[i]) * 0x1p24 - double(i) / 1000) < 0.07);  // Kolmogorov: once in 10^4 runs.
}

TEST_CASE("a sphere is sampled within the solid angle it covers, and uniformly") {
  const Scene scene = scene_with(SphereSet{"", {{{0.2f, 2, 0.3f}, 1}}});
  const double solid_angle = 2 * M_PI * (1 - std::sqrt(1 - 1.0 / 9));
  CHECK(inverse_density(scene, 1).mean() == Approx(solid_angle).epsilon(of_few_floats));
}

TEST_CASE("a sphere light's own surface gets none of its light, inside as outside") {
  Random random(3);
  for (const Vec3& center : {Vec3{0, 0, 0}, Vec3{0.3f, -1.7f, 2.1f}, Vec3{100, 20, -300}}) {
    const Sphere sphere{center, 0.37f};
    const Scene scene = scene_with(SphereSet{"", {sphere}});
    const LightSet lights(scene);
    for (int i = 0; i < 1000; ++i) {
      SurfacePoint on_lamp = sphere_point(sphere, 1, normalize(random.in_ball()));
      const Vec3 normal = i % 2 == 0 ? on_lamp.geometric_normal : -on_lamp.geometric_normal;
      const LightSample sample = lights.sample(0, on_lamp, {on_lamp.position, normal}, in_square(random));
      CHECK(is_black(sample.radiance));
    }
  }
}

TEST_CASE("the mean of 1 / density of a mesh light is its solid angle") {
  Mesh square = floor_square(1, 1);  // seen from two below its centre line
  for (Vec3& p : square.positions) p = p + Vec3{0.2f, 0, 0.3f};
  const SampleMean mean = inverse_density(scene_with(square), 2);
  // Of a square of half-width a at height h: 4 asin(a^2 / (a^2 + h^2)).
  const double solid_angle = 4 * std::asin(1.0 / 5);
  CHECK(z_test(mean, solid_angle) > sidak_level(1));
  CHECK(seen_error(mean.standard_error(), sidak_level(1)) <= 0.01 * solid_angle);
}

TEST_CASE("the mean of 1 / density of a mesh light of many triangles is its solid angle") {
  Mesh square;  // The same square, of 50 triangles whose areas differ by a factor of 10,000.
  const float at[] = {-1, -0.98f, -0.9f, -0.5f, 0, 1};
  for (const float z : at)
    for (const float x : at) square.positions.push_back({x + 0.2f, 1, z + 0.3f});
  for (std::uint32_t row = 0; row < 5; ++row)
    for (std::uint32_t i = 6 * row; i < 6 * row + 5; ++i) {
      square.triangles.push_back({i, i + 1, i + 7});
      square.triangles.push_back({i, i + 7, i + 6});
    }
  const SampleMean mean = inverse_density(scene_with(square), 4);
  const double solid_angle = 4 * std::asin(1.0 / 5);
  CHECK(z_test(mean, solid_angle) > sidak_level(1));
  CHECK(seen_error(mean.standard_error(), sidak_level(1)) <= 0.01 * solid_angle);
}

TEST_CASE("the density of a sample is the density that is asked for") {
  for (const bool sphere : {false, true}) {
    Mesh ball = icosphere(2);
    for (Vec3& p : ball.positions) p = p + Vec3{0, 2, 0};
    const Scene scene =
        scene_with(sphere ? Shape{SphereSet{"", {{{1, 2, 0}, 0.7f}}}} : Shape{std::move(ball)});
    const LightSet lights(scene);
    const auto engine = build_accelerator(Backend::brute_force, scene.geometry);
    Random random(3);
    int checked = 0;
    for (int i = 0; i < 1000; ++i) {
      const LightSample sample = lights.sample(0, below(), receiver(), in_square(random));
      if (is_black(sample.radiance)) continue;
      // The end of the shadow ray lies just off the light; the surface there is where a ray on from it would
      // hit.
      const Ray on{
          .origin = below().position, .direction = sample.direction, .t_min = 0.01f};  // off the floor
      const Hit hit = engine->closest_hit(on);
      if (hit.is_miss() || scene.bindings[hit.mesh].light != 0) continue;
      const SurfacePoint seen = surface_at(*scene.geometry, hit);
      const Vec3 end = sample.shadow_ray.origin + sample.shadow_ray.direction;
      if (length(seen.position - end) > 1e-4f) continue;  // another part of the light is in front
      CHECK(lights.pdf(0, {below().position, {0, 1, 0}}, hit) == Approx(sample.pdf).epsilon(1e-3));
      ++checked;
    }
    CHECK(checked > 300);
  }
}

TEST_CASE("a light shows its radiance on its sides, and other surfaces show none") {
  Scene scene = scene_of(floor_square(5, -1), {0.5f, 0.5f, 0.5f}, {0, 1, 5}, {0, 0, 0});
  const std::uint32_t lamp = add_lamp(scene, floor_square(1, 1), {3, 2, 1}, EmissionSide::front);
  const LightSet lights(scene);
  const SurfacePoint on_lamp = triangle_point(*scene.geometry, lamp, 0, 0.3f, 0.3f);
  CHECK(lights.emitted(on_lamp, {0, 1, 0}) == Rgb{3, 2, 1});
  CHECK(lights.emitted(on_lamp, {0, -1, 0}) == Rgb{});
  CHECK(lights.emitted(triangle_point(*scene.geometry, 0, 0, 0.3f, 0.3f), {0, 1, 0}) == Rgb{});
}

TEST_CASE("a sphere light shows its radiance outside, and is black from within") {
  const Scene scene = scene_with(SphereSet{"", {{{0.2f, 2, 0.3f}, 1}}});
  const LightSet lights(scene);
  const Sphere& sphere = scene.geometry->sphere_set(1)->spheres[0];
  Random random(9);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 normal = normalize(random.in_ball());
    const Vec3 wo = normalize(random.in_ball());
    const SurfacePoint point = sphere_point(sphere, 1, normal);
    CHECK(lights.emitted(point, wo) == (dot(normal, wo) > 0 ? Rgb{3, 2, 1} : Rgb{}));
    SurfacePoint within = below();
    within.position = sphere.center + normal * (0.99f * random.unit());
    CHECK(is_black(
        lights.sample(0, within, {within.position, within.shading_normal}, in_square(random)).radiance));
    CHECK(lights.pdf(0, {within.position, within.shading_normal}, {.primitive = 0, .mesh = 1}) == 0);
  }
}

TEST_CASE("the camera sees an environment but no ambient light, and bounces see both") {
  Scene scene = scene_of(floor_square(5, -1), {0.5f, 0.5f, 0.5f}, {0, 1, 5}, {0, 0, 0});
  add_light(scene, AmbientLight{{0, 1, 0}, {1, 1, 1}});
  auto map = std::make_shared<Image>(4, 2);
  for (Rgb& pixel : map->pixels) pixel = {0.25f, 0.5f, 2};
  add_light(scene, EnvironmentLight{map});
  const LightSet lights(scene);
  CHECK(lights.background({0, 1, 0}) == Rgb{0.25f, 0.5f, 2});
  CHECK(lights.escaped({0, 1, 0}) == Rgb{1.25f, 1.5f, 3});
  CHECK(lights.escaped({0, -1, 0}) == Rgb{0.25f, 0.5f, 2});
}

TEST_CASE("distant lights state the density and the radiance of their samples, one by one") {
  Scene scene = scene_of(floor_square(5, -1), {0.5f, 0.5f, 0.5f}, {0, 1, 5}, {0, 0, 0});
  add_light(scene, PointLight{{0, 1, 0}, {1, 1, 1}, {}});
  add_light(scene, AmbientLight{normalize({1, 1, 0}), {1, 2, 3}});
  for (const int seed : {1, 2}) {
    auto map = std::make_shared<Image>(6, 3);
    Random random{std::uint64_t(seed)};
    for (Rgb& pixel : map->pixels) pixel = {random.unit(), random.unit(), random.unit()};
    add_light(scene, EnvironmentLight{map});
  }
  const LightSet lights(scene, {.compensation = 1});
  CHECK(std::vector(lights.distant().begin(), lights.distant().end()) == std::vector<std::uint32_t>{1, 2, 3});
  CHECK(lights.pdf(0, {0, 1, 0}) == 0);
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    Rgb all;
    for (const std::uint32_t light : lights.distant()) {
      const LightSample sample = lights.sample(light, below(), receiver(), in_square(random));
      CHECK(lights.pdf(light, sample.direction) == sample.pdf);
      CHECK(lights.radiance(light, sample.direction) == sample.radiance);
      all += lights.radiance(light, normalize({0.3f, 0.2f, 0.1f}));
    }
    CHECK(lights.escaped(normalize({0.3f, 0.2f, 0.1f})) == all);
  }
}

TEST_CASE("views of distant lights have their radiance and density, direction by direction") {
  Scene scene = scene_of(floor_square(5, -1), {0.5f, 0.5f, 0.5f}, {0, 1, 5}, {0, 0, 0});
  Random random(6);
  auto map = std::make_shared<Image>(6, 3);
  for (Rgb& pixel : map->pixels) pixel = {random.unit(), random.unit(), random.unit()};
  add_light(scene, SunLight{{0, -1, 0}, {1, 1, 1}, 170});
  add_light(scene, PointLight{{0, 1, 0}, {1, 1, 1}, {}});
  add_light(scene, EnvironmentLight{map});
  add_light(scene, AmbientLight{normalize({1, 1, 0}), {1, 2, 3}});
  const LightSet lights(scene, {.compensation = 1});
  REQUIRE(lights.distant().size() == 3);
  for (const std::size_t count : {0u, 1u, 64u, 65u, 150u}) {
    CAPTURE(count);
    std::vector<Vec3> directions(count);
    for (Vec3& direction : directions) direction = normalize(random.in_ball());
    std::vector<Environment::View> views(3 * count);
    lights.view(directions, views);
    std::vector<Rgb> radiances(count, {8, 9, 10});
    lights.background(directions, radiances);
    for (std::size_t i = 0; i < count; ++i) {
      CHECK(radiances[i] == lights.background(directions[i]));
      for (std::size_t place = 0; place < 3; ++place) {
        const std::uint32_t light = lights.distant()[place];
        CHECK(views[3 * i + place].radiance == lights.radiance(light, directions[i]));
        CHECK(views[3 * i + place].pdf == lights.pdf(light, directions[i]));
        CHECK(lights.view(light, directions[i]).radiance == lights.radiance(light, directions[i]));
      }
    }
  }
}

TEST_CASE("a sun shines from a disc whose irradiance is the stated one, and is seen as it is sampled") {
  constexpr double rounding_of_disc = 1e-4;
  for (const float degrees : {0.01f, 0.53f, 20.0f, 170.0f}) {
    CAPTURE(degrees);
    Scene scene = scene_of(floor_square(5, -1), {0.5f, 0.5f, 0.5f}, {0, 1, 5}, {0, 0, 0});
    const Vec3 towards = normalize({0.3f, 0.9f, -0.2f});
    add_light(scene, SunLight{-towards, {3, 2, 1}, degrees});
    const LightSet lights(scene);
    CHECK_FALSE(lights.is_delta(0));
    const double radius = degrees * M_PI / 360;
    CHECK(lights.background(towards).r == Approx(3 / (M_PI * std::sin(radius) * std::sin(radius))));
    CHECK(is_black(lights.background(-towards)));
    Random random(5);
    SampleMean irradiance;
    int outside = 0;
    for (int i = 0; i < 20000; ++i) {
      const LightSample sample = lights.sample(0, below(), receiver(), in_square(random));
      CHECK(sample.pdf == Approx(1 / (2 * M_PI * (1 - std::cos(radius)))).epsilon(1e-3));
      irradiance.add(double(sample.radiance.r) * double(dot(sample.direction, towards)) / double(sample.pdf));
      // Rounded directions may lie just beyond the edge.
      if (lights.pdf(0, sample.direction) != sample.pdf) ++outside;
    }
    CHECK(irradiance.mean() == Approx(3).epsilon(degrees > 90 ? 0.01 : rounding_of_disc + 0.001));
    CHECK(outside < 200);
  }
}

TEST_CASE("an environment's rows run from up to down, its columns once around") {
  Image map(8, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 8; ++x) map.at(x, y) = {float(x), float(y), 1};
  const auto seen = [&](const Vec3& direction) {
    return map_value(MapLayout::latitude_longitude, map, map_point(MapLayout::latitude_longitude, direction));
  };
  // The poles: the first and the last row.
  CHECK(seen({0, 1, 0}).g == 0);
  CHECK(seen({0, -1, 0}).g == 3);
  // On the horizon, between the rows 1 and 2; +x is the middle column line, -z a quarter turn on, -x the
  // seam.
  CHECK(seen({1, 0, 0}) == Rgb{3.5f, 1.5f, 1});
  CHECK(seen({0, 0, -1}) == Rgb{5.5f, 1.5f, 1});
  CHECK(seen({0, 0, 1}) == Rgb{1.5f, 1.5f, 1});
  CHECK(seen({-1, 0, 0}) == Rgb{3.5f, 1.5f, 1});  // half of column 7 and half of column 0
}

}  // namespace twinray::test

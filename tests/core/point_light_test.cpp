// SPDX-License-Identifier: Apache-2.0
#include "core/point_light.h"

#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/random.h"

namespace twinray::test {
namespace {

SurfacePoint at(const Vec3& position) {
  SurfacePoint point;
  point.position = position;
  point.geometric_normal = point.shading_normal = {0, 1, 0};
  return point;
}

/// Along the axis turned by an angle.
Vec3 tilted(double degrees) {
  const double a = degrees * M_PI / 180;
  return {float(std::sin(a)), -float(std::cos(a)), 0};
}

}  // namespace

TEST_CASE("a spot's penumbra falls smoothly from full strength to none along the cone's edge") {
  SpotLight spot;
  spot.direction = {0, -1, 0};
  spot.intensity = {2, 2, 2};
  spot.falloff_angle_degrees = 60;
  spot.penumbra_degrees = 10;
  CHECK(intensity_along(spot, tilted(0)).r == 2);
  CHECK(intensity_along(spot, tilted(19.9)).r == 2);
  CHECK(intensity_along(spot, tilted(30.1)).r == 0);
  // pbrt's smoothstep of the cosine between those of 30 and of 20 degrees.
  for (const double degrees : {21.0, 25.0, 29.0}) {
    const double outer = std::cos(M_PI / 6), inner = std::cos(M_PI / 9);
    const double t = (std::cos(degrees * M_PI / 180) - outer) / (inner - outer);
    CHECK(intensity_along(spot, tilted(degrees)).r == Approx(2 * t * t * (3 - 2 * t)).epsilon(1e-4));
  }
  CHECK(light_from(spot, at({0, -4, 0})).radiance.r == Approx(2.0 / 16));
  spot.penumbra_degrees = 0;
  CHECK(intensity_along(spot, tilted(29.9)).r == 2);
}

TEST_CASE("a point's power is 4 pi of its intensity, a spot's its cone's, where light falls as 1/d^2") {
  const PointLight point{{}, {1, 2, 3}, {0, 0, 2}};  // Half of the light: 1 / (2 d^2).
  CHECK(power_of(point).b == Approx(6 * M_PI));
  CHECK(is_black(power_of(PointLight{{}, {1, 2, 3}, {1, 0, 0}})));
  CHECK(is_black(power_of(PointLight{{}, {1, 2, 3}, {0, 1, 1}})));
  CHECK(is_black(power_of(PointLight{{}, {1, 2, 3}, {0, 0, 0}})));
  SpotLight spot;
  spot.intensity = {1, 2, 3};
  spot.falloff_angle_degrees = 120;
  CHECK(power_of(spot).r == Approx(2 * M_PI * 0.5));
  spot.penumbra_degrees = 60;  // The mean of its soft edge is a half.
  CHECK(power_of(spot).g == Approx(2 * M_PI * 0.5));
  for (const float angle : {4.0f, 40.0f, 180.0f, 360.0f})
    for (const float exponent : {0.0f, 3.0f, 2000.0f})
      for (const float penumbra : {0.0f, 0.2f, 0.5f}) {
        CAPTURE(angle, exponent, penumbra);
        spot.falloff_angle_degrees = angle, spot.falloff_exponent = exponent;
        spot.penumbra_degrees = penumbra * angle;
        constexpr int steps = 200000;
        double sum = 0;
        for (int i = 0; i < steps; ++i) {
          const double a = angle / 360 * M_PI * (i + 0.5) / steps;
          const Vec3 direction{float(std::sin(a)), 0, -float(std::cos(a))};
          sum += double(intensity_along(spot, direction).r) * std::sin(a);
        }
        CHECK(power_of(spot).r == Approx(2 * M_PI * sum * angle / 360 * M_PI / steps).epsilon(1e-3));
      }
}

TEST_CASE("a goniometric light of an even picture is a point light, and its picture turns with it") {
  const auto grey = std::make_shared<Image>(Image(4, 4, {0.5f, 0.5f, 0.5f}));
  const GoniometricLight even{{1, 2, 3}, {3, 2, 1}, grey};
  const PointLight point{{1, 2, 3}, {1.5f, 1, 0.5f}, {}};
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const SurfacePoint surface = at(random.in_ball() * 5);
    const LightSample one = light_from(even, surface), other = light_from(point, surface);
    CHECK(one.direction == other.direction);
    CHECK(one.pdf == 1);
    CHECK(one.radiance.r == Approx(other.radiance.r));
    CHECK(one.radiance.b == Approx(other.radiance.b));
    CHECK(one.shadow_ray.direction == other.shadow_ray.direction);
  }
  auto up = std::make_shared<Image>(16, 8);
  for (int x = 0; x < 16; ++x)
    for (int y = 0; y < 4; ++y) up->at(x, y) = {1, 1, 1};  // The upper half of all directions.
  GoniometricLight lamp{{}, {1, 1, 1}, up, MapLayout::latitude_longitude};
  CHECK(intensity_along(lamp, {0, 1, 0}).r == 1);
  CHECK(intensity_along(lamp, {0, -1, 0}).r == 0);
  lamp.rotation = Transform::rotation({0, 0, 1}, -90);  // up becomes +x
  CHECK(intensity_along(lamp, {1, 0, 0}).r == 1);
  CHECK(intensity_along(lamp, {-1, 0, 0}).r == 0);
  CHECK(light_from(lamp, at({2, 0, 0})).radiance.r == Approx(0.25));
  CHECK(is_black(light_from(lamp, at({-2, 0, 0})).radiance));
}

TEST_CASE("a projection light throws its picture upright into its frame, and nothing beside it") {
  auto picture = std::make_shared<Image>(2, 2);
  picture->pixels = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};  // red, green; blue, white
  ProjectionLight slide;
  slide.tan_half_width = 2;
  slide.tan_half_height = 0.5f;
  slide.intensity = {3, 3, 3};
  slide.picture = picture;
  const auto along = [&](float x, float y) { return intensity_along(slide, normalize(Vec3{x, y, -1})); };
  CHECK(along(-1.5f, 0.4f) == Rgb{3, 0, 0});
  CHECK(along(1.5f, 0.4f) == Rgb{0, 3, 0});
  CHECK(along(-1.5f, -0.4f) == Rgb{0, 0, 3});
  CHECK(along(1.5f, -0.4f) == Rgb{3, 3, 3});
  CHECK(along(0, 0.4f).r == Approx(1.5).epsilon(1e-4));
  CHECK_FALSE(is_black(along(1.99f, 0.49f)));
  CHECK(is_black(along(2.01f, 0)));
  CHECK(is_black(along(0, -0.51f)));
  CHECK(is_black(intensity_along(slide, {0, 0, 1})));
  CHECK(light_from(slide, at({-3, 0.8f, -2})).radiance.r == Approx(3 / (9 + 0.64 + 4)));
}

TEST_CASE("a point at the light itself gets none") {
  CHECK(is_black(light_from(PointLight{{0, 1, 0}, {1, 1, 1}, {}}, at({0, 1, 0})).radiance));
}

}  // namespace twinray::test

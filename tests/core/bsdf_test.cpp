// SPDX-License-Identifier: Apache-2.0
#include "core/bsdf.h"

#include "core/frame.h"
#include "core/warp.h"
#include "tests/support/catch.h"
#include "tests/support/chi_square.h"
#include "tests/support/lobe_checks.h"
#include "tests/support/measured_facets.h"
#include "tests/support/random.h"

namespace twinray {
namespace {

Bsdf lambert(float reflectance) { return Bsdf(Lambert{{reflectance, reflectance, reflectance}}); }

Vec3 random_direction(test::Random& random) {
  const float u = random.unit();
  const float v = random.unit();
  return square_to_uniform_sphere({u, v});
}

}  // namespace

TEST_CASE("a Lambert surface scatters reflectance / pi on the viewer's side, and is reciprocal") {
  test::Random random(1);
  const Bsdf bsdf = lambert(0.6f);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 wo = random_direction(random);
    const Vec3 wi = random_direction(random);
    const bool same_side = wo.z * wi.z > 0;
    CHECK(bsdf.evaluate(wo, wi).value.g == (same_side ? 0.6f * (1 / pi) : 0.0f));
    CHECK(bsdf.evaluate(wo, wi).value == bsdf.evaluate(wi, wo).value);
  }
}

TEST_CASE("sampled directions have the stated density, from both sides") {
  const Bsdf bsdf = lambert(0.6f);
  for (const float side : {1.0f, -1.0f}) {
    test::Random random(2);
    test::Grid grid(12, 12);  // cos^2 and azimuth are uniform under a cosine density
    const Vec3 wo{0.6f, 0, 0.8f * side};
    for (int i = 0; i < 100000; ++i) {
      const float u = random.unit();
      const float v = random.unit();
      const BsdfSample sample = bsdf.sample(wo, 0, {u, v});
      REQUIRE(sample.wi.z * side > 0);
      REQUIRE(sample.pdf == bsdf.evaluate(wo, sample.wi).pdf);
      REQUIRE(sample.value == bsdf.evaluate(wo, sample.wi).value);
      grid.add(double(sample.wi.z) * sample.wi.z, std::atan2(sample.wi.y, sample.wi.x) / (2 * M_PI) + 0.5);
    }
    test::check_uniform(grid.counts(), 2, 0.035);
  }
}

TEST_CASE("light from behind is scattered by those that let light through, and by no other") {
  Principled clear;
  clear.transmission_weight = 0.5f;
  clear.specular_roughness = 0.5f;
  const SurfaceModel models[] = {Lambert{},
                                 Mirror{},
                                 Microfacet{},
                                 Conductor{.roughness = {0.3f, 0.3f}},
                                 RoughDiffuse{},
                                 CoatedDiffuse{},
                                 CoatedConductor{},
                                 Principled{},
                                 Dielectric{1.5f},
                                 clear,
                                 DiffuseTransmission{},
                                 Dielectric{1.5f, {0.3f, 0.3f}},
                                 test::measured_material(white),
                                 Hair{}};
  int through = 0;
  for (const SurfaceModel& model : models) {
    const Bsdf bsdf(model);
    Random random(3);
    bool is_seen = false;
    for (int i = 0; i < 2000; ++i) {
      Vec3 wo = normalize(random.in_ball()), wi = normalize(random.in_ball());
      wo.z = std::fabs(wo.z);
      wi.z = -std::fabs(wi.z);
      const auto [value, pdf] = bsdf.evaluate(wo, wi);
      is_seen = is_seen || !is_black(value) || pdf > 0;
    }
    CAPTURE(model.index());
    CHECK(is_seen == bsdf.lets_light_through());
    through += is_seen;
  }
  CHECK(through == 4);
}

TEST_CASE("facets narrower than a thousandth are smooth, and wider ones near that look smooth") {
  const Vec3 wo = test::direction_at(0.6f), image{-wo.x, -wo.y, wo.z};
  const auto is_delta = [&](const SurfaceModel& model) {
    return Bsdf(model).sample(wo, 0, {0.3f, 0.6f}).is_delta;
  };
  for (const float alpha : {0.0f, 9e-4f, 1.1e-3f}) {
    const Roughness roughness{alpha, 0};
    const bool smooth = alpha < 1e-3f;
    CAPTURE(alpha);
    CHECK(is_delta(Conductor{.roughness = roughness}) == smooth);
    CHECK(is_delta(Dielectric{.roughness = roughness}) == smooth);
    CHECK(is_delta(CoatedDiffuse{.roughness = roughness}) == smooth);
    CHECK(length(Bsdf(Conductor{.roughness = roughness}).sample(wo, 0.5f, {0.3f, 0.6f}).wi - image) < 5e-3f);
  }
  CHECK(is_delta(Dielectric{.ior = 1, .roughness = {0.5f, 0.5f}}));
}

TEST_CASE("a sheet that would scatter more light than there is scatters all of it, in proportion") {
  const Vec3 wo{0, 0, 1};
  const auto scattered = [&](const DiffuseTransmission& sheet, float side) {
    return Bsdf(sheet).evaluate(wo, {0, 0, side}).value * pi;
  };
  const DiffuseTransmission bright{{0.9f, 0.5f, 0}, {0.6f, 1, 0.75f}};
  CHECK(scattered(bright, 1).r == Approx(0.6));
  CHECK(scattered(bright, -1).r == Approx(0.4));
  CHECK(scattered(bright, 1).g == Approx(0.5 / 1.5));
  CHECK(scattered(bright, -1).b == Approx(0.75 / 1.5));
  CHECK(scattered({{0.5f, 0.5f, 0.5f}, {0.25f, 0.25f, 0.25f}}, 1).r == Approx(0.5));
}

TEST_CASE("a rough boundary is seen from the side that the viewer is on") {
  const Dielectric glass{.ior = 1.5f, .roughness = {0.2f, 0.2f}};
  // With the draw 1 facets refract: into the denser medium, or out of it.
  const Vec3 wo{0.3f, 0, std::sqrt(1 - 0.09f)};
  CHECK(Bsdf(glass, Side::outside).sample(wo, 1, {0.5f, 0.9f}).eta == 1.5f);
  CHECK(Bsdf(glass, Side::inside).sample(wo, 1, {0.5f, 0.9f}).eta == 1 / 1.5f);
}

TEST_CASE("a frame is orthonormal around any normal, and maps back and forth") {
  test::Random random(3);
  // A few roundings of unit vectors.
  constexpr float rounding = 1e-6f;
  for (int i = 0; i < 10000; ++i) {
    const Vec3 n = i < 6 ? Vec3{i % 3 == 0 ? 1.0f : 0, i % 3 == 1 ? 1.0f : 0, i % 3 == 2 ? 1.0f : 0} *
                               (i < 3 ? 1.0f : -1.0f)
                         : normalize(random.in_ball());
    const Frame frame(n);
    CHECK(std::fabs(dot(frame.tangent, n)) <= rounding);
    CHECK(std::fabs(dot(frame.tangent, frame.bitangent)) <= rounding);
    CHECK(length(cross(frame.tangent, frame.bitangent) - n) <= rounding);
    const Vec3 v = normalize(random.in_ball());
    CHECK(length(frame.to_world(frame.to_local(v)) - v) <= rounding);
  }
}

}  // namespace twinray

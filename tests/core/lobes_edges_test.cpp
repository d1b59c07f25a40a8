// SPDX-License-Identifier: Apache-2.0
// All models at the ends of their parameters and of directions: at the horizon, along the normal, at the
// corners of the unit square.
#include "core/bsdf.h"
#include "tests/support/catch.h"
#include "tests/support/measured_facets.h"
#include "tests/support/random.h"

namespace twinray {
namespace {

constexpr Rgb black{};
/// The least number below 1 that a draw has.
constexpr float almost_1 = 0x1.fffffep-1f;

std::vector<SurfaceModel> models_of(const Roughness& roughness, const Rgb& tint) {
  std::vector<SurfaceModel> models = {Lambert{tint},
                                      Mirror{tint},
                                      DiffuseTransmission{tint * 0.5f, tint * 0.5f},
                                      RoughDiffuse{tint, roughness.x},
                                      Hair{tint, roughness.x, roughness.y, 30},
                                      Hair{black, roughness.x, roughness.y, 30, 1},
                                      Hair{tint, 0.5f, 0.5f, 1e30f, 1e30f},
                                      test::measured_material(tint, roughness.x == roughness.y ? 1 : 5),
                                      Microfacet{std::max(roughness.x, 0.01f), {0.2f, 1, 3}, {4, 1, 0}}};
  for (const float ior : {0.5f, 1.0f, 1.0001f, 1.5f, 4.0f}) {
    models.push_back(Dielectric{ior, roughness, tint, tint, false});
    models.push_back(Dielectric{ior, roughness, tint, tint, true});
    models.push_back(CoatedDiffuse{tint, roughness, ior});
    for (const Rgb& k : {black, white, Rgb{9, 0.1f, 4}}) {
      models.push_back(Conductor{{0, 1, 2.5f}, k, roughness, tint});
      models.push_back(CoatedConductor{{0, 1, 2.5f}, k, roughness, tint, {roughness.y, roughness.x}, ior});
    }
  }
  return models;
}

/// Any direction above; one in three at the horizon, one in three along the normal, nearly.
Vec3 direction(test::Random& random, int i) {
  Vec3 w = normalize(random.in_ball());
  if (i % 3 == 1) w.z *= std::ldexp(1.0f, -random.between(5, 20));
  if (i % 3 == 2) w.x *= 1e-4f, w.y = 0;
  w = normalize(w);
  w.z = std::max(std::fabs(w.z), 0x1p-20f);
  return w;
}

float draw(test::Random& random) {
  const int kind = random.below(6);
  return kind == 0 ? 0 : kind == 1 ? almost_1 : random.unit();
}

bool is_usable(const Rgb& c) { return is_finite(c) && c.r >= 0 && c.g >= 0 && c.b >= 0; }

void check_sample(const Bsdf& bsdf, const Vec3& wo, test::Random& random) {
  const float lobe = draw(random);
  const float x = draw(random);
  const float y = draw(random);
  const BsdfSample s = bsdf.sample(wo, lobe, {x, y});
  CAPTURE(lobe, x, y, s.wi.x, s.wi.y, s.wi.z, s.pdf);
  REQUIRE((s.pdf >= 0 && std::isfinite(s.pdf)));
  if (s.pdf == 0) return;
  REQUIRE(is_usable(s.value));
  REQUIRE(s.wi.z != 0);
  REQUIRE(std::fabs(length(s.wi) - 1) < 1e-4f);
}

}  // namespace

TEST_CASE("no model scatters what is negative or not finite, at the ends of its parameters and directions") {
  test::Random random(7);
  for (const Roughness& roughness : {Roughness{0, 0}, {1e-3f, 1e-3f}, {0.02f, 1}, {0.3f, 0.3f}, {1, 1}})
    for (const Rgb& tint : {black, white, Rgb{0, 1, 0.5f}})
      for (const SurfaceModel& model : models_of(roughness, tint))
        for (const Side side : {Side::outside, Side::inside}) {
          const Bsdf bsdf(model, side);
          REQUIRE(is_usable(bsdf.albedo()));
          REQUIRE(max_component(bsdf.albedo()) <= 1.001f);
          for (int i = 0; i < 60; ++i) {
            const Vec3 wo = direction(random, i);
            Vec3 wi = direction(random, random.below(3));
            if (random.below(2) == 0) wi.z = -wi.z;
            CAPTURE(model.index(), roughness.x, roughness.y, tint.r, int(side), wo.x, wo.y, wo.z, wi.x, wi.y,
                    wi.z);
            REQUIRE(is_usable(bsdf.evaluate(wo, wi).value));
            const float pdf = bsdf.evaluate(wo, wi).pdf;
            REQUIRE((pdf >= 0 && std::isfinite(pdf)));
            check_sample(bsdf, wo, random);
          }
        }
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Rough diffuse surfaces, and those that let light through.
#include "core/lobes/diffuse_transmission.h"
#include "core/lobes/rough_diffuse.h"
#include "tests/support/lobe_checks.h"

namespace twinray {
namespace {

using test::direction_at;

const float diffuse_cosines[] = {1.0f, 0.7f, 0.3f, 0.05f};
constexpr Rgb grey{0.2f, 0.5f, 0.8f};

}  // namespace

TEST_CASE("a rough diffuse surface is sampled with its density, and is reciprocal") {
  test::Random random(3);
  for (const float roughness : {0.0f, 0.4f, 1.0f}) {
    const RoughDiffuseLobe lobe(grey, roughness);
    for (const float cosine : diffuse_cosines) test::check_sampling(lobe, direction_at(cosine), 12);
    for (int i = 0; i < 200; ++i) {
      Vec3 wo = normalize(random.in_ball()), wi = normalize(random.in_ball());
      wo.z = std::fabs(wo.z), wi.z = std::fabs(wi.z);
      CHECK(lobe.evaluate(wo, wi).value.r == Approx(lobe.evaluate(wi, wo).value.r).epsilon(1e-5));
      CHECK(lobe.evaluate(wo, test::flipped(wi)).value == Rgb{});
    }
  }
}

TEST_CASE("a rough white diffuse surface passes the furnace") {
  constexpr double fit = 1.5e-3;
  for (const float roughness : {0.0f, 0.2f, 0.5f, 1.0f})
    for (const float cosine : diffuse_cosines) {
      CAPTURE(roughness, cosine);
      CHECK(std::fabs(test::scattered(RoughDiffuseLobe(white, roughness), direction_at(cosine)).g - 1) <=
            fit);
      CHECK(max_component(test::scattered(RoughDiffuseLobe(grey, roughness), direction_at(cosine))) < 0.81f);
    }
}

TEST_CASE("a diffuse surface without roughness is Lambert's, with roughness it shines back at the light") {
  const Vec3 wo = direction_at(0.5f);
  const Rgb lambert = grey * (1 / pi);
  CHECK(RoughDiffuseLobe(grey, 0).evaluate(wo, direction_at(0.3f)).value.g ==
        Approx(lambert.g).epsilon(1e-6));
  const Vec3 opposite{-wo.x, -wo.y, wo.z};
  CHECK(RoughDiffuseLobe(grey, 1).evaluate(wo, wo).value.g >
        1.5f * RoughDiffuseLobe(grey, 1).evaluate(wo, opposite).value.g);
  // Its albedo, about, is what it scatters of light from all around.
  double sum = 0;
  for (int i = 0; i < 20; ++i) {
    const float cosine = (float(i) + 0.5f) / 20;
    sum += 2 * cosine * test::scattered(RoughDiffuseLobe(grey, 1), direction_at(cosine), 4).g / 20;
  }
  CHECK(RoughDiffuseLobe(grey, 1).albedo().g == Approx(sum).epsilon(5e-3));
}

TEST_CASE("diffuse transmission is sampled with its density, and parts the light as stated") {
  const Rgb reflectance{0.1f, 0.4f, 0.2f}, transmittance{0.2f, 0.3f, 0.6f};
  const DiffuseTransmissionLobe both{reflectance, transmittance}, one{{}, transmittance},
      other{reflectance, {}};
  const Vec3 wo = direction_at(0.3f);
  for (const DiffuseTransmissionLobe& lobe : {both, one, other}) {
    test::check_sampling(lobe, wo, 3);
    CHECK(test::scattered(lobe, wo).b == Approx(lobe.albedo().b).epsilon(1e-3));
    CHECK(test::sampled_albedo(lobe, wo).b == Approx(lobe.albedo().b).epsilon(2e-2));
  }
  CHECK(both.evaluate(wo, {0, 0, 1}).value == reflectance * (1 / pi));
  CHECK(both.evaluate(wo, {0, 0, -1}).value == transmittance * (1 / pi));
  CHECK((DiffuseTransmissionLobe{{}, {}}.sample(wo, 0.5f, {0.5f, 0.3f}).pdf) == 0);
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "core/lobes/coated_conductor.h"

#include "core/fresnel.h"
#include "tests/support/layers.h"

namespace twinray {
namespace {

using test::coat_cosines;
using test::coat_of;
using test::direction_at;

/// Relative to a coat of 1.5.
const Rgb coated_eta{0.11f, 0.28f, 0.97f}, coated_k{2.32f, 1.61f, 1.18f};

CoatedConductorLobe gold(float coat_alpha, float alpha) {
  return {coat_of(coat_alpha), Ggx(alpha), coated_eta, coated_k, white};
}

}  // namespace

TEST_CASE("a coated conductor is sampled with its density, and is reciprocal") {
  test::Random random(3);
  for (const float coat_alpha : {0.0f, 0.2f})
    for (const float alpha : {0.1f, 0.4f, 1.0f}) {
      CAPTURE(coat_alpha, alpha);
      const CoatedConductorLobe lobe = gold(coat_alpha, alpha);
      for (const float cosine : coat_cosines) test::check_sampling(lobe, direction_at(cosine), 18, 24);
      for (int i = 0; i < 200; ++i) {
        Vec3 wo = normalize(random.in_ball()), wi = normalize(random.in_ball());
        wo.z = std::fabs(wo.z), wi.z = std::fabs(wi.z);
        CHECK(lobe.evaluate(wo, wi).value.g == Approx(lobe.evaluate(wi, wo).value.g).epsilon(1e-4));
        CHECK(lobe.evaluate(wo, test::flipped(wi)).value == Rgb{});
      }
    }
}

TEST_CASE("a coated white metal passes the furnace within the fit's error") {
  for (const float ior : {1.3f, 1.5f, 2.0f})
    for (const float coat_alpha : {0.0f, 0.1f, 0.5f})
      for (const float alpha : {0.05f, 0.3f, 1.0f})
        for (const float cosine : coat_cosines) {
          CAPTURE(ior, coat_alpha, alpha, cosine);
          const double fit = ior == 1.5f ? 0.07 : 0.13;  // It was fitted at 1.5.
          const CoatedConductorLobe lobe(coat_of(coat_alpha, ior), Ggx(alpha), {}, white, white);
          CHECK(std::fabs(test::sampled_albedo(lobe, direction_at(cosine), 40000).g - 1) <= fit);
        }
}

TEST_CASE("a coated white metal of two alphas passes the furnace as one without direction does") {
  for (const Ggx& facets : {Ggx(0.1f, 0.5f), Ggx(0.7f, 0.3f)})
    for (const float coat_alpha : {0.0f, 0.1f}) {
      const CoatedConductorLobe lobe(coat_of(coat_alpha, 1.5f), facets, {}, white, white);
      double sum = 0;
      constexpr int rings = 6, around = 12;
      for (int i = 0; i < rings; ++i)
        for (int j = 0; j < around; ++j) {
          const float cosine = std::sqrt((float(i) + 0.5f) / rings);
          const SinCos angle = sincos_turns((float(j) + 0.5f) / around);
          const float sine = std::sqrt(1 - cosine * cosine);
          sum += test::sampled_albedo(lobe, {sine * angle.cos, sine * angle.sin, cosine}, 4000).g;
        }
      CAPTURE(facets.alpha_x(), facets.alpha_y(), coat_alpha);
      CHECK(std::fabs(sum / (rings * around) - 1) <= 0.045);  // 0.03 of it is the fit's for one alpha.
    }
}

TEST_CASE("a coated conductor brings about what a walk through the layers brings") {
  for (const float coat_alpha : {0.0f, 0.05f})
    for (const float alpha : {0.05f, 0.1f, 0.3f, 0.6f, 1.0f})
      for (const float cosine : coat_cosines) {
        CAPTURE(coat_alpha, alpha, cosine);
        // The facets of the walk's rough coat lose light.
        const double fit = coat_alpha > 0 ? 0.1 : 0.06, of_a_ring = coat_alpha > 0 ? 0.055 : 0.02;
        const RoughConductorLobe metal(Ggx(alpha), coated_eta, coated_k, white);
        const auto walked = test::layer_rings(1.5f, coat_alpha, metal, direction_at(cosine), 1000);
        const auto ours = test::lobe_rings(gold(coat_alpha, alpha), direction_at(cosine));
        CHECK(std::fabs(test::sum_of_means(ours) - test::sum_of_means(walked)) <= fit);
        for (std::size_t i = 0; i < ours.size(); ++i)
          CHECK(std::fabs(ours[i].mean() - walked[i].mean()) <= of_a_ring);
      }
}

TEST_CASE("a smooth coated conductor is a mirror, and the limit of rough ones") {
  const SmoothCoatedConductorLobe lobe(1.5f, coated_eta, coated_k, white), mirror(1.5f, {}, white, white);
  for (const float cosine : coat_cosines) {
    CAPTURE(cosine);
    const Vec3 wo = direction_at(cosine);
    const BsdfSample sample = lobe.sample(wo, 0.5f, {0.5f, 0.5f});
    CHECK(sample.is_delta);
    CHECK(sample.wi == Vec3{-wo.x, -wo.y, wo.z});
    CHECK(test::sampled_albedo(mirror, wo, 10).g == Approx(1));
    const float fresnel = fresnel_dielectric(cosine, 1.5f);
    const float metal = fresnel_conductor(refracted_cosine(cosine, 1.5f), coated_eta.g, coated_k.g);
    // Reflections between the layers, one after the other.
    double sum = fresnel, light = 1 - fresnel;
    for (int i = 0; i < 50; ++i) {
      light *= metal;
      sum += light * (1 - fresnel);
      light *= fresnel;
    }
    CHECK(sample.value.g * wo.z == Approx(sum).epsilon(1e-5));
    const CoatedConductorLobe rough(Coat(1.5f), Ggx(0.002f), coated_eta, coated_k, white);
    CHECK(test::sampled_albedo(rough, wo, 20000).g == Approx(sum).margin(0.03));
  }
}

}  // namespace twinray

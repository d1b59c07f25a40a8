// SPDX-License-Identifier: Apache-2.0
#include "core/lobes/rough_dielectric.h"

#include "core/fresnel.h"
#include "tests/support/lobe_checks.h"

namespace twinray {
namespace {

using test::direction_at;

/// Refraction narrows peaks, and ends at an edge.
constexpr int fine = 32;
const float glass_cosines[] = {1.0f, 0.6f, 0.2f};
const Ggx glass_distributions[] = {Ggx(0.15f), Ggx(0.4f), Ggx(1.0f), Ggx(0.15f, 0.5f), Ggx(1.0f, 0.05f)};
/// Into glass, out of it, and out of diamond.
const float ratios[] = {1.5f, 1 / 1.5f, 1 / 2.4f};

RoughDielectricLobe glass(const Ggx& facets, float eta) { return {facets, eta, white, white}; }

/// The same boundary, for a viewer on its other side.
RoughDielectricLobe other_side(const Ggx& facets, float eta) { return glass(facets, 1 / eta); }

}  // namespace

TEST_CASE("a rough dielectric is sampled with its density, from both sides") {
  for (const Ggx& facets : glass_distributions)
    for (const float eta : ratios)
      for (const float cosine : glass_cosines) {
        CAPTURE(facets.alpha_x(), facets.alpha_y(), eta, cosine);
        test::check_sampling(glass(facets, eta), direction_at(cosine), 40, fine);
      }
  test::check_sampling(RoughDielectricLobe(Ggx(0.3f), 1.5f, {0.1f, 0.2f, 0.3f}, {0.5f, 0.9f, 0.5f}),
                       direction_at(0.3f), 40, fine);
  test::check_sampling(RoughDielectricLobe(Ggx(0.3f), 1.5f, {}, white), direction_at(0.3f), 40, fine);
  test::check_sampling(RoughDielectricLobe(Ggx(0.3f), 1.5f, white, {}), direction_at(0.3f), 40, fine);
}

TEST_CASE("a rough dielectric is reciprocal, by eta squared where it transmits") {
  test::Random random(3);
  int refracted = 0;
  for (const Ggx& facets : glass_distributions)
    for (const float eta : ratios)
      for (int i = 0; i < 200; ++i) {
        Vec3 wo = normalize(random.in_ball()), wi = normalize(random.in_ball());
        wo.z = std::fabs(wo.z);
        if (wi.z > 0) {
          const float there = glass(facets, eta).evaluate(wo, wi).value.g;
          CHECK(there == Approx(glass(facets, eta).evaluate(wi, wo).value.g).epsilon(1e-4));
          continue;
        }
        const float there = glass(facets, eta).evaluate(wo, wi).value.g;
        const float back = other_side(facets, eta).evaluate(test::flipped(wi), test::flipped(wo)).value.g;
        CAPTURE(eta, wo.z, wi.z);
        CHECK(there * eta * eta == Approx(back).epsilon(1e-3).margin(1e-6));
        if (there > 0) ++refracted;
      }
  CHECK(refracted > 300);
}

TEST_CASE("light that meets one facet of a rough dielectric is sampled with its density") {
  for (const Ggx& facets : glass_distributions)
    for (const float eta : ratios)
      test::check_sampling(DielectricFacets(facets, eta, white, white), direction_at(0.6f), 12, fine);
}

TEST_CASE("a rough dielectric passes the furnace on both sides") {
  constexpr double tables = 0.03;
  for (const float alpha : {0.05f, 0.1f, 0.3f, 0.6f, 1.0f})
    for (const float eta : ratios)
      for (const float cosine : glass_cosines) {
        CAPTURE(alpha, eta, cosine);
        const Vec3 wo = direction_at(cosine);
        CHECK(std::fabs(test::sampled_albedo(glass(Ggx(alpha), eta), wo, 50000).g - 1) <= tables);
      }
  for (const Ggx& facets : {Ggx(0.15f, 0.5f), Ggx(0.7f, 0.3f), Ggx(0.05f, 1.0f)})
    for (const float eta : ratios)
      for (const float cosine : glass_cosines) {
        CAPTURE(facets.alpha_x(), facets.alpha_y(), eta, cosine);
        const Vec3 wo = direction_at(cosine);
        CHECK(std::fabs(test::sampled_albedo(glass(facets, eta), wo, 50000).g - 1) <= 0.06);
      }
  // Without light that meets several facets a third would be left.
  const DielectricFacets once(Ggx(1.0f), 1 / 2.4f, white, white);
  CHECK(test::sampled_albedo(once, direction_at(1)).g == Approx(0.31).margin(0.01));
}

TEST_CASE("a nearly smooth dielectric splits light as a smooth one") {
  const RoughDielectricLobe lobe = glass(Ggx(0.001f), 1.5f);
  for (const float cosine : glass_cosines) {
    CAPTURE(cosine);
    const Vec3 wo = direction_at(cosine);
    const float fresnel = fresnel_dielectric(cosine, 1.5f);
    const BsdfSample reflected = lobe.sample(wo, fresnel * 0.5f, {0.3f, 0.5f});
    CHECK(length(reflected.wi - Vec3{-wo.x, -wo.y, wo.z}) < 5e-3f);
    CHECK(reflected.eta == 1);
    const BsdfSample refracted = lobe.sample(wo, fresnel * 1.5f, {0.3f, 0.5f});
    CHECK(length(refracted.wi - Vec3{-wo.x / 1.5f, -wo.y / 1.5f, -refracted_cosine(cosine, 1.5f)}) < 5e-3f);
    CHECK(refracted.eta == 1.5f);
    // Radiance within the glass is that outside, compressed by eta^2.
    CHECK(refracted.value.g * std::fabs(refracted.wi.z) / refracted.pdf == Approx(1 / 2.25).epsilon(1e-2));
  }
}

}  // namespace twinray

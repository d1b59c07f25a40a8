// SPDX-License-Identifier: Apache-2.0
// Our lobes beside Mitsuba's, direction by direction, from a stored table.
#include "core/lobes/coated_diffuse.h"
#include "core/lobes/dielectric_facets.h"
#include "core/lobes/rough_conductor.h"
#include "tests/core/mitsuba_table.h"
#include "tests/support/catch.h"

namespace twinray {
namespace {

using test::Reference;

Vec3 direction(float theta_degrees, float phi_degrees) {
  const double theta = theta_degrees * M_PI / 180, phi = phi_degrees * M_PI / 180;
  return {float(std::sin(theta) * std::cos(phi)), float(std::sin(theta) * std::sin(phi)),
          float(std::cos(theta))};
}

Vec3 viewer(const Reference& r) { return direction(r.theta_o, r.phi_o); }
Vec3 light(const Reference& r) { return direction(r.theta_i, r.phi_i); }

/// Mitsuba hides facets from both directions as if these had nothing to do with each other, G1 G1; we know
/// that high facets are seen from everywhere.
float uncorrelated(const Ggx& facets, const Vec3& wo, const Vec3& wi) {
  return facets.masking(wo) * facets.masking(wi) / facets.shadowing_masking(wo, wi);
}

/// A narrow peak turns the rounding of a direction into this.
constexpr double rounding = 2e-4;

void check_same(const Rgb& ours, const Rgb& theirs, double relative) {
  CHECK(ours.r == Approx(theirs.r).epsilon(relative).margin(1e-7));
  CHECK(ours.g == Approx(theirs.g).epsilon(relative).margin(1e-7));
  CHECK(ours.b == Approx(theirs.b).epsilon(relative).margin(1e-7));
}

}  // namespace

TEST_CASE("rough conductors are Mitsuba's, but for light that meets several facets") {
  for (const Reference& r : test::conductors) {
    CAPTURE(r.alpha_x, r.alpha_y, r.theta_o, r.theta_i, r.phi_i);
    const Ggx facets(r.alpha_x, r.alpha_y);
    const Vec3 wo = viewer(r), wi = light(r);
    const RoughConductorLobe lobe(facets, {0.2f, 0.92f, 1.1f}, {3.9f, 2.45f, 2.14f}, {1, 1, 1});
    const FacetReflection facet = facets.reflection(wo, wi);
    check_same(lobe.single_scattering(facet) * uncorrelated(facets, wo, wi), r.value, rounding);
    CHECK(facet.pdf == Approx(r.pdf).epsilon(rounding));
  }
}

TEST_CASE("rough dielectrics are Mitsuba's from both sides, but for light that meets several facets") {
  for (const Reference& r : test::dielectrics) {
    CAPTURE(r.alpha_x, r.eta, r.theta_o, r.theta_i, r.phi_i);
    const Ggx facets(r.alpha_x, r.alpha_y);
    const Vec3 wo = viewer(r), wi = light(r);
    const DielectricFacets lobe(facets, r.eta, {1, 1, 1}, {1, 1, 1});
    check_same(lobe.evaluate(wo, wi).value * uncorrelated(facets, wo, wi), r.value, rounding);
    CHECK(lobe.evaluate(wo, wi).pdf == Approx(r.pdf).epsilon(rounding).margin(1e-7));
  }
}

TEST_CASE("what comes through a smooth coat is that of Mitsuba's plastic") {
  // Mitsuba takes the average of Fresnel's reflectance from a fit.
  constexpr double fit = 2e-3;
  for (const Reference& r : test::plastics) {
    CAPTURE(r.eta, r.theta_o, r.theta_i);
    const CoatedDiffuseLobe lobe(Coat(r.eta), {0.2f, 0.5f, 0.8f});
    check_same(lobe.evaluate(viewer(r), light(r)).value, r.value, fit);
  }
}

TEST_CASE("a rough coat brings Mitsuba's rough plastic, and what that loses") {
  // Mitsuba's coat, as pbrt's, loses what its facets scatter to each other; ours lets it through.
  for (const Reference& r : test::rough_plastics) {
    CAPTURE(r.alpha_x, r.theta_o, r.theta_i, r.phi_i);
    const double lost = r.alpha_x < 0.2f ? 0.14 : 0.55;
    const CoatedDiffuseLobe lobe(Coat(r.eta, Ggx(r.alpha_x)), {0.2f, 0.5f, 0.8f});
    const Rgb ours = lobe.evaluate(viewer(r), light(r)).value;
    CHECK(ours.g > r.value.g * 0.99f);
    CHECK(ours.g < r.value.g * (1 + lost));
    CHECK(ours.b > r.value.b * 0.99f);
    CHECK(ours.b < r.value.b * (1 + lost));
  }
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Losses of facets of two alphas, also between the tables' entries, against the integrals that they stand
// for.
#include "core/ggx_directions.h"

#include "core/ggx_albedo.h"
#include "core/lobes/dielectric_facets.h"
#include "tests/support/catch.h"
#include "tests/support/lobe_checks.h"

namespace twinray {
namespace {

const Ggx brushed[] = {{0.02f, 0.9f}, {0.1f, 0.5f},   {0.5f, 0.1f}, {0.3f, 0.7f},
                       {0.05f, 0.2f}, {0.96f, 0.55f}, {0.4f, 0.5f}, {0.001f, 0.3f}};
constexpr float turns[] = {0, 0.04f, 0.11f, 0.18f, 0.25f};

Vec3 direction(float cosine, float turn) {
  const float sine = std::sqrt((1 - cosine) * (1 + cosine));
  const SinCos angle = sincos_turns(turn);
  return {sine * angle.cos, sine * angle.sin, cosine};
}

/// What facets that absorb nothing lose of light along wo, by `count`^2 visible normals.
double exact_loss(const Ggx& facets, const Vec3& wo, int count) {
  double sum = 0;
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j) {
      const Vec2 u{(float(i) + 0.5f) / float(count), (float(j) + 0.5f) / float(count)};
      const Vec3 wi = reflected(wo, facets.sample_visible(wo, u));
      if (wi.z > 0) sum += facets.shadowing_masking(wo, wi) / facets.masking(wo);
    }
  return 1 - sum / count / count;
}

/// The integral of cos f(w) / pi.
template <class Function>
double average_around(const Function& f) {
  constexpr int rings = 24, around = 16;
  double sum = 0;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < around; ++j)
      sum += f(direction(std::sqrt((float(i) + 0.5f) / rings), (float(j) + 0.5f) / around));
  return sum / rings / around;
}

}  // namespace

TEST_CASE("what facets of two alphas lose along a direction is tabulated within the stated error") {
  double of_one_alpha = 0, sum = 0;
  for (const Ggx& facets : brushed)
    for (const float cosine : {0.05f, 0.12f, 0.3f, 0.55f, 0.8f, 0.99f})
      for (const float turn : turns) {
        const Vec3 wo = direction(cosine, turn);
        CAPTURE(facets.alpha_x(), facets.alpha_y(), cosine, turn);
        const double exact = exact_loss(facets, wo, 100), found = MultipleScattering(facets).loss(wo);
        CHECK(std::fabs(found - exact) <= 0.06);
        sum += std::fabs(found - exact);
        of_one_alpha += std::fabs(ggx_loss(cosine, facets.mean_alpha()) - exact);
      }
  CHECK(sum < 0.3 * of_one_alpha);
}

TEST_CASE("beside the horizon losses of facets of two alphas are within the stated error") {
  for (const Ggx& facets : {Ggx(1.0f, 0.001f), Ggx(1.0f, 0.087f), Ggx(0.029f, 0.48f), Ggx(0.5f, 0.1f)})
    for (const float cosine : {0.02f, 0.05f, 0.09f})
      for (const float turn : {0.0f, 0.06f, 0.125f, 0.225f, 0.25f}) {
        const Vec3 wo = direction(cosine, turn);
        CAPTURE(facets.alpha_x(), facets.alpha_y(), cosine, turn);
        CHECK(std::fabs(MultipleScattering(facets).loss(wo) - exact_loss(facets, wo, 100)) <= 0.13);
      }
}

TEST_CASE("facets of two alphas lose on average what they lose along all directions") {
  for (const Ggx& facets : brushed) {
    CAPTURE(facets.alpha_x(), facets.alpha_y());
    const MultipleScattering metal(facets);
    CHECK(metal.average_loss() ==
          Approx(average_around([&](const Vec3& w) { return metal.loss(w); })).margin(3e-3));
    CHECK(metal.average_loss() ==
          Approx(average_around([&](const Vec3& w) { return exact_loss(facets, w, 40); })).margin(0.014));
    for (const float eta : {1.3f, 1.5f, 2.2f, 1 / 1.3f, 1 / 1.5f, 1 / 2.2f}) {
      const DielectricMultipleScattering glass(facets, eta);
      CAPTURE(eta);
      const double along = average_around([&](const Vec3& w) { return glass.loss(w); });
      const float alpha = facets.mean_alpha();
      CHECK(average_ggx_boundary_loss(alpha, eta) + average_ggx_boundary_loss_change(facets, eta) ==
            Approx(along).margin(0.015));
    }
  }
}

TEST_CASE("what a boundary's facets of two alphas lose is nearer to the integral than that of one alpha") {
  for (const float eta : {1.5f, 1 / 1.5f}) {
    double with = 0, without = 0, mean = 0, count = 0;
    for (const Ggx& facets : brushed)
      for (const float cosine : {0.1f, 0.3f, 0.6f, 0.9f})
        for (const float turn : turns) {
          const Vec3 wo = direction(cosine, turn);
          const DielectricFacets once(facets, eta, {1, 1, 1}, {1, 1, 1});
          const double exact = 1 - test::sampled_albedo(once, wo, 4000).g;
          const double found = DielectricMultipleScattering(facets, eta).loss(wo);
          with += std::fabs(found - exact);
          without += std::fabs(ggx_boundary_loss(cosine, facets.mean_alpha(), eta) - exact);
          mean += found - exact;
          ++count;
        }
    CAPTURE(eta, with / count, without / count, mean / count);
    CHECK(with < 0.5 * without);
    CHECK(std::fabs(mean / count) < 0.01);
  }
}

TEST_CASE("a direction's share of both alphas is that of x along the normal, and the axes' along the axes") {
  const Ggx facets(0.2f, 0.6f);
  CHECK(facets.azimuth({0, 0, 1}).share == Approx(0.25));
  CHECK(facets.azimuth({0, 0, 1}).skew2 == 0);
  CHECK(facets.azimuth({0.6f, 0, 0.8f}).share == Approx(0.25));
  CHECK(facets.azimuth({0.6f, 0, 0.8f}).skew2 == 0);
  CHECK(facets.azimuth({0, -0.6f, 0.8f}).share == Approx(0.75));
  const Azimuth between = facets.azimuth(direction(0.5f, 0.125f));
  CHECK(between.share == Approx(0.5));
  CHECK(between.skew2 == Approx(0.64));  // (0.6^2 - 0.2^2) / (0.6^2 + 0.2^2), squared.
}

}  // namespace twinray

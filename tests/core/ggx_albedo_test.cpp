// SPDX-License-Identifier: Apache-2.0
// The tables, also between their entries, against the integrals that they stand for.
#include "core/ggx_albedo.h"

#include "core/fresnel.h"
#include "core/lobes/dielectric_facets.h"
#include "tests/support/catch.h"
#include "tests/support/lobe_checks.h"

namespace twinray {
namespace {

constexpr float alphas[] = {0.02f, 0.1f, 0.25f, 0.43f, 0.7f, 0.98f};
constexpr float albedo_cosines[] = {0.02f, 0.09f, 0.3f, 0.55f, 0.83f, 1.0f};

/// The mean of f(wi) / p(wi) = F G2 / G1 over `count`^2 visible normals; `fresnel` of the cosine to them.
template <class Fresnel>
double reflected_part(float cosine, float alpha, int count, const Fresnel& fresnel) {
  const Ggx ggx(alpha);
  const Vec3 wo = test::direction_at(cosine);
  double sum = 0;
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j) {
      const Vec3 m =
          ggx.sample_visible(wo, {(float(i) + 0.5f) / float(count), (float(j) + 0.5f) / float(count)});
      const Vec3 wi = reflected(wo, m);
      if (wi.z <= 0) continue;
      sum += ggx.shadowing_masking(wo, wi) / ggx.masking(wo) * fresnel(std::min(1.0f, dot(wo, m)));
    }
  return sum / count / count;
}

/// The integral of 2 cos f(cos), cos = t^2.
template <class Function>
double coarse_average(const Function& f) {
  constexpr int count = 50;
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const float t = (float(i) + 0.5f) / count;
    sum += 4 * t * t * t * f(t * t) / count;
  }
  return sum;
}

float one(float) { return 1; }

}  // namespace

TEST_CASE("what facets lose after one reflection is tabulated within the stated error") {
  constexpr double stated = 3e-3;
  for (const float alpha : alphas)
    for (const float cosine : albedo_cosines) {
      CAPTURE(alpha, cosine);
      CHECK(std::fabs(ggx_loss(cosine, alpha) - (1 - reflected_part(cosine, alpha, 300, one))) <= stated);
    }
  for (const float alpha : alphas) {
    CAPTURE(alpha);
    const double exact = coarse_average([&](float c) { return 1 - reflected_part(c, alpha, 250, one); });
    CHECK(std::fabs(average_ggx_loss(alpha) - exact) <= 2e-3);
  }
  CHECK(ggx_loss(1, 1) == Approx(std::log(2)).epsilon(2e-3));  // The integral's closed form.
}

TEST_CASE("smooth facets lose nothing, and the tables end where facets do") {
  for (const float cosine : albedo_cosines) CHECK(ggx_loss(cosine, 0) <= 4e-3f);
  CHECK(average_ggx_loss(0) <= 1e-4f);
  CHECK(ggx_loss(1, 2) == ggx_loss(1, 1));
  CHECK(std::isfinite(ggx_loss(0, 0)));
  CHECK(GgxDielectricReflectance(0.5f, 0.9f)(0.5f) == 0);
}

TEST_CASE("what dielectric facets of a high index reflect is tabulated within the stated error") {
  for (const float ior : {3.01f, 5.0f, 8.0f, 17.0f, 25.0f, 40.0f, 90.0f, 1000.0f})
    for (const float alpha : alphas) {
      const GgxDielectricReflectance facets(alpha, ior);
      const auto exact = [&](float c) {
        return reflected_part(c, alpha, 100, [&](float m) { return fresnel_dielectric(m, ior); });
      };
      for (const float cosine : albedo_cosines) {
        CAPTURE(ior, alpha, cosine);
        CHECK(std::fabs(facets(cosine) - exact(cosine)) <= (cosine < 0.1f ? 0.05 : 0.015));
      }
      CAPTURE(ior, alpha);
      CHECK(std::fabs(facets.average() - coarse_average(exact)) <= 0.015);
    }
}

TEST_CASE("what dielectric facets reflect is tabulated within the stated error") {
  for (const float ior : {1.2f, 1.33f, 1.5f, 1.8f, 2.5f}) {
    const auto fresnel = [&](float c) { return fresnel_dielectric(c, ior); };
    for (const float alpha : alphas) {
      for (const float cosine : albedo_cosines) {
        CAPTURE(ior, alpha, cosine);
        const double stated = cosine < 0.1f ? 2e-2 : 5e-3;
        CHECK(std::fabs(GgxDielectricReflectance(alpha, ior)(cosine) -
                        reflected_part(cosine, alpha, 100, fresnel)) <= stated);
      }
      CAPTURE(ior, alpha);
      const double exact = coarse_average([&](float c) { return reflected_part(c, alpha, 80, fresnel); });
      CHECK(std::fabs(GgxDielectricReflectance(alpha, ior).average() - exact) <= 3e-3);
    }
    CHECK(GgxDielectricReflectance(0, ior).average() == Approx(average_fresnel_dielectric(ior)).margin(3e-3));
  }
}

TEST_CASE("what a boundary's facets lose is tabulated within the stated error, on both sides") {
  constexpr int samples = 60000;
  for (const float eta : {1.2f, 1.5f, 2.4f, 1 / 1.2f, 1 / 1.5f, 1 / 2.4f})
    for (const float alpha : alphas) {
      double average = 0;
      for (int i = 0; i < 10; ++i) {
        const float cosine = (float(i) + 0.5f) / 10;
        CAPTURE(eta, alpha, cosine);
        const DielectricFacets facets(Ggx(alpha), eta, {1, 1, 1}, {1, 1, 1});
        const double lost = 1 - test::sampled_albedo(facets, test::direction_at(cosine), samples).g;
        CHECK(std::fabs(ggx_boundary_loss(cosine, alpha, eta) - lost) <= 0.03);
        average += 2 * cosine * lost / 10;
      }
      CAPTURE(eta, alpha);
      CHECK(std::fabs(average_ggx_boundary_loss(alpha, eta) - average) <= 0.02);
    }
}

}  // namespace twinray

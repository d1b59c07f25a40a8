// SPDX-License-Identifier: Apache-2.0
#include "core/lobes/cs184_microfacet.h"

#include "tests/support/lobe_checks.h"

namespace twinray {
namespace {

using test::direction_at;

const Rgb gold_eta{0.16f, 0.42f, 1.45f}, gold_k{3.48f, 2.42f, 1.77f};

/// The formulas of the course, in double, from angles.
double course(const Vec3& wo, const Vec3& wi, double alpha, double eta, double k) {
  const Vec3 h = normalize(wo + wi);
  const double c = wi.z, squares = eta * eta + k * k;
  const double rs = (squares - 2 * eta * c + c * c) / (squares + 2 * eta * c + c * c);
  const double rp = (squares * c * c - 2 * eta * c + 1) / (squares * c * c + 2 * eta * c + 1);
  const double theta = std::atan2(std::hypot(double(h.x), double(h.y)), double(h.z));
  const double d =
      std::exp(-std::pow(std::tan(theta) / alpha, 2)) / (M_PI * alpha * alpha * std::pow(std::cos(theta), 4));
  const auto lambda = [&](const Vec3& w) {
    const double a = 1 / (alpha * std::tan(std::acos(std::min(1.0, double(w.z)))));
    return 0.5 * (std::erf(a) - 1 + std::exp(-a * a) / (a * M_PI));
  };
  return 0.5 * (rs + rp) / (1 + lambda(wo) + lambda(wi)) * d / (4 * wo.z * wi.z);
}

}  // namespace

TEST_CASE("CS184's microfacets have the values of the course's formulas") {
  test::Random random(3);
  for (const float alpha : {0.05f, 0.25f, 0.5f, 1.0f})
    for (int i = 0; i < 300; ++i) {
      Vec3 wo = normalize(random.in_ball()), wi = normalize(random.in_ball());
      wo.z = std::fabs(wo.z), wi.z = std::fabs(wi.z);
      CAPTURE(alpha, wo.x, wo.y, wo.z, wi.x, wi.y, wi.z);
      const Cs184MicrofacetLobe lobe(alpha, gold_eta, gold_k);
      const double expected = course(wo, wi, alpha, gold_eta.g, gold_k.g);
      // exp(-x) has x times the rounding of x.
      CHECK(lobe.evaluate(wo, wi).value.g == Approx(expected).epsilon(2e-4).margin(1e-6));
      CHECK(lobe.evaluate(wo, test::flipped(wi)).value == Rgb{});
      CHECK(lobe.evaluate(test::flipped(wo), wi).value == Rgb{});
    }
}

TEST_CASE("CS184's microfacets are sampled with their density") {
  for (const float alpha : {0.1f, 0.25f, 0.5f})
    for (const float cosine : {1.0f, 0.6f, 0.2f}) {
      CAPTURE(alpha, cosine);
      test::check_sampling(Cs184MicrofacetLobe(alpha, gold_eta, gold_k), direction_at(cosine), 9);
    }
}

TEST_CASE("CS184's microfacets scatter too much at the horizon, as the course's formulas do") {
  // Facets that reflect everything.
  const Rgb none{}, all{1e4f, 1e4f, 1e4f};
  for (const float alpha : {0.05f, 0.25f, 0.5f, 1.0f})
    for (const float cosine : {1.0f, 0.6f, 0.2f, 0.05f}) {
      CAPTURE(alpha, cosine);
      const float part = test::scattered(Cs184MicrofacetLobe(alpha, none, all), direction_at(cosine), 32).g;
      CHECK(part > 0.5f);
      CHECK(part < (cosine > 0.5f ? 1.02f : 1.65f));
    }
}

}  // namespace twinray

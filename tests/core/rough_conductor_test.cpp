// SPDX-License-Identifier: Apache-2.0
#include "core/lobes/rough_conductor.h"

#include "core/fresnel.h"
#include "tests/support/lobe_checks.h"

namespace twinray {
namespace {

using test::direction_at;

const Rgb copper_eta{0.2f, 0.92f, 1.1f}, copper_k{3.9f, 2.45f, 2.14f};
const float metal_cosines[] = {1.0f, 0.7f, 0.3f, 0.08f};
const Ggx metal_distributions[] = {Ggx(0.1f),        Ggx(0.4f),       Ggx(1.0f),       Ggx(0.1f, 0.5f),
                                   Ggx(0.7f, 0.15f), Ggx(0.3f, 0.7f), Ggx(1.0f, 0.05f)};

RoughConductorLobe copper(const Ggx& facets) { return {facets, copper_eta, copper_k, {1, 1, 1}}; }
/// Facets that reflect everything.
RoughConductorLobe white_metal(const Ggx& facets) { return {facets, {}, {1, 1, 1}, {1, 1, 1}}; }

}  // namespace

TEST_CASE("a rough conductor is sampled with its density") {
  for (const Ggx& facets : metal_distributions)
    for (const float cosine : metal_cosines) {
      CAPTURE(facets.alpha_x(), facets.alpha_y(), cosine);
      test::check_sampling(copper(facets), direction_at(cosine), 20);
    }
}

TEST_CASE("a rough conductor is reciprocal and scatters to the viewer's side only") {
  test::Random random(3);
  for (const Ggx& facets : metal_distributions)
    for (int i = 0; i < 200; ++i) {
      Vec3 wo = normalize(random.in_ball()), wi = normalize(random.in_ball());
      wo.z = std::fabs(wo.z), wi.z = std::fabs(wi.z);
      const RoughConductorLobe lobe = copper(facets);
      CHECK(lobe.evaluate(wo, wi).value.g == Approx(lobe.evaluate(wi, wo).value.g).epsilon(1e-5));
      CHECK(lobe.evaluate(wo, {wi.x, wi.y, -wi.z}).value == Rgb{});
      CHECK(lobe.evaluate(wo, {wi.x, wi.y, -wi.z}).pdf == 0);
    }
}

TEST_CASE("a rough white metal passes the furnace") {
  // The tables' errors, as stated.
  for (const Ggx& facets : metal_distributions)
    for (const float cosine : metal_cosines) {
      const double stated = facets.alpha_x() == facets.alpha_y() ? 5e-3 : 0.03;
      CAPTURE(facets.alpha_x(), facets.alpha_y(), cosine);
      const float all = test::scattered(white_metal(facets), direction_at(cosine), 24).g;
      CHECK(std::fabs(all - 1) <= stated);
      CHECK(test::sampled_albedo(white_metal(facets), direction_at(cosine)).g == Approx(all).epsilon(5e-3));
    }
  // Without compensation more than half would be missing.
  const auto single = [](const Vec3& wo, const Vec3& wi) {
    const Ggx facets(1.0f);
    return wi.z > 0 ? white_metal(facets).single_scattering(facets.reflection(wo, wi)) : Rgb{};
  };
  double sum = 0;
  test::SphereGrid::visit(8, [&](const Vec3& wi, double area, std::size_t) {
    sum += single({0, 0, 1}, wi).g * area * wi.z;
  });
  CHECK(sum == Approx(1 - std::log(2)).epsilon(1e-3));
}

TEST_CASE("a rough conductor never scatters more than it receives") {
  for (const float alpha : {0.1f, 0.5f, 1.0f})
    for (const float cosine : metal_cosines) {
      const Rgb all = test::scattered(copper(Ggx(alpha)), direction_at(cosine));
      CHECK(max_component(all) < 1);
      CHECK(all.r > all.g);
    }
}

TEST_CASE("a nearly smooth conductor reflects as much as a smooth one") {
  for (const float cosine : {1.0f, 0.7f, 0.3f}) {
    CAPTURE(cosine);
    const Rgb rough = test::sampled_albedo(copper(Ggx(0.002f)), direction_at(cosine), 20000);
    const Rgb smooth = fresnel_conductor(cosine, copper_eta, copper_k);
    CHECK(rough.r == Approx(smooth.r).margin(2e-3));
    CHECK(rough.g == Approx(smooth.g).margin(2e-3));
    CHECK(rough.b == Approx(smooth.b).margin(2e-3));
  }
}

TEST_CASE("a rough conductor's albedo is about what it scatters of light from all around") {
  for (const float alpha : {0.1f, 0.5f, 1.0f}) {
    double sum = 0;
    for (int i = 0; i < 10; ++i) {
      const float cosine = (float(i) + 0.5f) / 10;
      sum += 2 * cosine * test::scattered(copper(Ggx(alpha)), direction_at(cosine), 12).g / 10;
    }
    CHECK(copper(Ggx(alpha)).albedo().g == Approx(sum).epsilon(0.03));
  }
}

TEST_CASE("a brushed metal's highlight is long across its grooves") {
  const RoughConductorLobe lobe = copper(Ggx(0.5f, 0.05f));
  const Vec3 wo{0, 0, 1}, along_x = normalize({0.5f, 0, 1}), along_y = normalize({0, 0.5f, 1});
  CHECK(lobe.evaluate(wo, along_x).value.g > 10 * lobe.evaluate(wo, along_y).value.g);
}

}  // namespace twinray

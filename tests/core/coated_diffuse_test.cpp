// SPDX-License-Identifier: Apache-2.0
#include "core/lobes/coated_diffuse.h"

#include "core/lobes/lambert.h"
#include "core/lobes/rough_dielectric.h"
#include "tests/support/layers.h"

namespace twinray {
namespace {

using test::coat_cosines;
using test::coat_of;
using test::direction_at;

constexpr Rgb base_color{0.2f, 0.5f, 0.8f};

}  // namespace

TEST_CASE("a coated diffuse surface is sampled with its density, and is reciprocal") {
  test::Random random(3);
  for (const float alpha : {0.0f, 0.15f, 0.6f}) {
    const CoatedDiffuseLobe lobe(coat_of(alpha), base_color);
    for (const float cosine : coat_cosines) {
      CAPTURE(alpha, cosine);
      test::check_sampling(lobe, direction_at(cosine), 11);
    }
    for (int i = 0; i < 200; ++i) {
      Vec3 wo = normalize(random.in_ball()), wi = normalize(random.in_ball());
      wo.z = std::fabs(wo.z), wi.z = std::fabs(wi.z);
      CHECK(lobe.evaluate(wo, wi).value.r == Approx(lobe.evaluate(wi, wo).value.r).epsilon(1e-4));
      CHECK(lobe.evaluate(wo, test::flipped(wi)).value == Rgb{});
    }
  }
  test::check_sampling(CoatedDiffuseLobe(Coat(1.5f, Ggx(0.1f, 0.5f)), base_color), direction_at(0.5f), 11);
  test::check_sampling(CoatedDiffuseLobe(Coat(1.5f, Ggx(0.3f)), {}), direction_at(0.5f), 11, 24);
}

TEST_CASE("a coated white surface passes the furnace") {
  for (const float ior : {1.1f, 1.5f, 2.0f})
    for (const float cosine : coat_cosines) {
      CAPTURE(ior, cosine);
      // Exact; the sum over samples of the mirror's direction and of a smooth function errs by its noise.
      CHECK(test::sampled_albedo(CoatedDiffuseLobe(coat_of(0, ior), white), direction_at(cosine)).g ==
            Approx(1).margin(5e-3));
      // The tables' error.
      for (const float alpha : {0.1f, 0.5f, 1.0f}) {
        CAPTURE(alpha);
        CHECK(test::scattered(CoatedDiffuseLobe(coat_of(alpha, ior), white), direction_at(cosine), 32).g ==
              Approx(1).margin(1e-2));
      }
    }
}

TEST_CASE("a white surface below a coat of two alphas passes the furnace") {
  double mean = 0, count = 0;
  for (const Ggx& facets : {Ggx(0.05f, 0.2f), Ggx(0.5f, 0.1f), Ggx(0.3f, 0.7f), Ggx(0.02f, 1.0f)})
    for (const float cosine : {0.95f, 0.7f, 0.4f, 0.2f, 0.1f})
      for (const float turn : {0.0f, 0.05f, 0.125f, 0.2f, 0.25f}) {
        CAPTURE(facets.alpha_x(), facets.alpha_y(), cosine, turn);
        const SinCos angle = sincos_turns(turn);
        const float sine = std::sqrt(1 - cosine * cosine);
        const Vec3 wo{sine * angle.cos, sine * angle.sin, cosine};
        const CoatedDiffuseLobe lobe(Coat(1.5f, facets), white);
        const float all = test::sampled_albedo(lobe, wo, 20000).g;
        CHECK(std::fabs(all - 1) <= (cosine < 0.3f ? 0.08 : 0.03));
        mean += all * cosine, count += cosine;
      }
  CHECK(mean / count == Approx(1).margin(0.01));
}

TEST_CASE("white below a coat of any index returns all of the light that comes in") {
  for (const float ior : {1.5f, 100.0f, 1000.0f, 1e6f})
    for (const float alpha : {0.0f, 0.3f}) {
      const Coat coat = coat_of(alpha, ior);
      CHECK(coat.diffuse_below(white).g == Approx(1 / (1 - coat.average_reflectance())).epsilon(1e-4));
    }
}

TEST_CASE("a coat of the outside's own index is none") {
  const CoatedDiffuseLobe lobe(coat_of(0, 1), base_color);
  CHECK(lobe.evaluate(direction_at(0.5f), direction_at(0.7f)).value.g == Approx(base_color.g / pi));
  CHECK(lobe.albedo().g == Approx(base_color.g));
}

TEST_CASE("a smooth coat over a diffuse base is what a walk through the layers brings") {
  int failed = 0, compared = 0;
  const double limit = test::z_limit(test::sidak_level(9 * 8));
  for (const float cosine : coat_cosines)
    for (const float reflectance : {0.1f, 0.5f, 1.0f}) {
      const LambertLobe base{{reflectance, reflectance, reflectance}};
      const auto walked = test::layer_rings(1.5f, 0, base, direction_at(cosine), 1000);
      const auto ours =
          test::lobe_rings(CoatedDiffuseLobe(coat_of(0), base.reflectance), direction_at(cosine));
      for (std::size_t i = 0; i < walked.size(); ++i) {
        const double error = std::hypot(walked[i].standard_error(), ours[i].standard_error());
        if (std::fabs(walked[i].mean() - ours[i].mean()) > limit * error) ++failed;
        ++compared;
      }
    }
  CHECK(compared == 9 * 8);
  CHECK(failed == 0);
}

TEST_CASE("a rough coat brings as much as a walk through pbrt's layers, and what these lose") {
  // Facets of the walk, as of pbrt's, lose what they scatter to each other, most of all from below. Measured
  // at these reflectances and cosines; docs/materials.md has more.
  const auto difference = [](float alpha, float reflectance, float cosine) {
    const LambertLobe base{{reflectance, reflectance, reflectance}};
    const CoatedDiffuseLobe lobe(coat_of(alpha), base.reflectance);
    return test::sum_of_means(test::lobe_rings(lobe, direction_at(cosine))) -
           test::sum_of_means(test::layer_rings(1.5f, alpha, base, direction_at(cosine), 1000));
  };
  constexpr double noise = 0.002;
  for (const float cosine : coat_cosines) {
    CAPTURE(cosine);
    CHECK(difference(0.05f, 0.5f, cosine) > -noise);
    CHECK(difference(0.05f, 0.5f, cosine) < 0.012 + noise);
    CHECK(difference(0.1f, 0.2f, cosine) < 0.006 + noise);
    CHECK(difference(0.1f, 0.5f, cosine) < 0.02 + noise);
    CHECK(difference(0.3f, 0.5f, cosine) < 0.06 + noise);
    CHECK(difference(0.5f, 0.5f, cosine) < 0.1 + noise);
  }
}

TEST_CASE("a rough coat brings what a walk brings through layers that lose nothing") {
  constexpr double of_all = 0.026, of_a_ring = 0.006;
  for (const float reflectance : {0.2f, 0.8f})
    for (const float alpha : {0.05f, 0.3f, 1.0f})
      for (const float cosine : coat_cosines) {
        CAPTURE(reflectance, alpha, cosine);
        const LambertLobe base{{reflectance, reflectance, reflectance}};
        const CoatedDiffuseLobe lobe(coat_of(alpha), base.reflectance);
        const auto ours = test::lobe_rings(lobe, direction_at(cosine));
        const auto walked =
            test::layer_rings<RoughDielectricLobe>(1.5f, alpha, base, direction_at(cosine), 1000);
        CHECK(std::fabs(test::sum_of_means(ours) - test::sum_of_means(walked)) <= of_all);
        for (std::size_t i = 0; i < ours.size(); ++i)
          CHECK(std::fabs(ours[i].mean() - walked[i].mean()) <= of_a_ring);
      }
}

TEST_CASE("pbrt's cut after ten layers darkens a coated white surface by seven per cent") {
  const LambertLobe base{white}, grey_base{{0.5f, 0.5f, 0.5f}};
  const auto cut = [](const LambertLobe& b) {
    return test::sum_of_means(test::layer_rings(1.5f, 0, b, direction_at(1), 10));
  };
  CHECK(cut(base) == Approx(0.928).margin(3e-3));
  CHECK(cut(grey_base) == Approx(0.316).margin(3e-3));  // Without the cut it is 0.316, too.
}

}  // namespace twinray

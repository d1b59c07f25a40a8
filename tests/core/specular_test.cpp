// SPDX-License-Identifier: Apache-2.0
#include "core/lobes/specular.h"

#include "core/fresnel.h"
#include "tests/core/mitsuba_table.h"
#include "tests/support/lobe_checks.h"

namespace twinray {
namespace {

const float smooth_cosines[] = {1.0f, 0.7f, 0.3f, 0.02f};

Vec3 at_degrees(float theta) {
  const double radians = theta * M_PI / 180;
  return {float(std::sin(radians)), 0, float(std::cos(radians))};
}

BsdfSample sample_smooth(const test::SmoothReference& r, float lobe) {
  const Vec3 wo = at_degrees(r.theta_o);
  return r.is_thin ? ThinDielectricLobe(r.eta, white, white).sample(wo, lobe, {})
                   : SmoothDielectricLobe(r.eta, white, white).sample(wo, lobe, {});
}

}  // namespace

TEST_CASE("smooth and thin dielectrics are Mitsuba's, with total internal reflection") {
  constexpr double digits = 1e-5;
  for (const test::SmoothReference& r : test::smooth) {
    CAPTURE(r.is_thin, r.eta, r.theta_o);
    const BsdfSample reflected = sample_smooth(r, 0), last = sample_smooth(r, 0.999f);
    CHECK(reflected.pdf == Approx(r.reflection).epsilon(digits));
    CHECK(reflected.wi.z == Approx(at_degrees(r.theta_o).z));
    CHECK(reflected.eta == 1);
    CHECK(length(last.wi - r.wi) < 1e-5f);
    CHECK(last.value.g * std::fabs(last.wi.z) / last.pdf == Approx(r.factor).epsilon(digits));
    CHECK(last.is_delta);
  }
}

TEST_CASE("smooth white surfaces scatter all light, to directions with no density") {
  for (const float cosine : smooth_cosines) {
    const Vec3 wo = test::direction_at(cosine);
    const auto check = [&](const auto& lobe) {
      CHECK(test::sampled_albedo(lobe, wo, 2000).g == Approx(1).epsilon(1e-4));
      CHECK(lobe.evaluate(wo, {-wo.x, -wo.y, wo.z}).pdf == 0);
      CHECK(lobe.evaluate(wo, {-wo.x, -wo.y, wo.z}).value == Rgb{});
    };
    check(MirrorLobe(white));
    check(SmoothConductorLobe({}, white, white));
    check(ThinDielectricLobe(1.5f, white, white));
    for (const float eta : {1.0f, 1.5f, 1 / 1.5f, 2.4f}) check(SmoothDielectricLobe(eta, white, white));
  }
}

TEST_CASE("what a thin sheet reflects is the sum over the reflections within it") {
  for (const float cosine : smooth_cosines) {
    const double once = fresnel_dielectric(cosine, 1.5f);
    double sum = once, within = (1 - once) * (1 - once) * once;
    for (int i = 0; i < 200; ++i, within *= once * once) sum += within;
    const BsdfSample sample =
        ThinDielectricLobe(1.5f, white, white).sample(test::direction_at(cosine), 0, {});
    CHECK(sample.pdf == Approx(sum).epsilon(1e-4));
  }
}

}  // namespace twinray

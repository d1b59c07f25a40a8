// SPDX-License-Identifier: Apache-2.0
#include "core/lobes/fuzz.h"

#include <cmath>

#include "tests/support/lobe_checks.h"

namespace twinray {
namespace {

/// What it scatters of the light from all around, as a sum over the hemisphere.
double integrated(const Fuzz& fuzz, float cosine) {
  constexpr int parts = 300;
  const Vec3 wo = test::direction_at(cosine);
  double sum = 0;
  for (int i = 0; i < parts; ++i)
    for (int j = 0; j < parts; ++j) {
      const double z = (i + 0.5) / parts, turn = 2 * double(pi) * (j + 0.5) / parts;
      const double r = std::sqrt(1 - z * z);
      sum += z * fuzz.evaluate(wo, {float(r * std::cos(turn)), float(r * std::sin(turn)), float(z)});
    }
  return sum * 2 * double(pi) / (parts * parts);
}

}  // namespace

TEST_CASE("fuzz scatters what its table says, and never more than arrives") {
  for (const float roughness : {0.0f, 0.25f, 0.3f, 0.5f, 0.77f, 1.0f}) {
    const Fuzz fuzz(roughness);
    double average = 0;
    for (int i = 0; i < 50; ++i) {
      const float cosine = (float(i) + 0.5f) / 50;
      average += 2 * cosine * fuzz.reflectance(cosine) / 50;
      CHECK(fuzz.reflectance(cosine) < 1);
    }
    CHECK(fuzz.average_reflectance() == Approx(average).margin(2e-3));
    for (const float cosine : {0.003f, 0.05f, 0.3f, 0.6f, 0.9f, 1.0f}) {
      CAPTURE(roughness, cosine);
      CHECK(std::fabs(fuzz.reflectance(cosine) - integrated(fuzz, cosine)) < 5e-3);
    }
  }
}

TEST_CASE("fuzz is brighter at the rim, the more so the smoother it is") {
  const Fuzz smooth(0.25f), rough(1);
  CHECK(smooth.reflectance(0.05f) > 3 * smooth.reflectance(0.5f));
  CHECK(smooth.reflectance(0.05f) > rough.reflectance(0.05f));
  CHECK(smooth.reflectance(1) < rough.reflectance(1));
}

}  // namespace twinray

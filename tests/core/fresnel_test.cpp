// SPDX-License-Identifier: Apache-2.0
#include "core/fresnel.h"

#include <complex>

#include "tests/support/catch.h"

namespace twinray {
namespace {

using Complex = std::complex<double>;

/// Fresnel's equations as they stand in books, in complex double.
double reflectance(double cos_i, Complex index) {
  const Complex cos_t = std::sqrt(1.0 - (1 - cos_i * cos_i) / (index * index));
  const Complex parallel = (index * cos_i - cos_t) / (index * cos_i + cos_t);
  const Complex perpendicular = (cos_i - index * cos_t) / (cos_i + index * cos_t);
  return 0.5 * (std::norm(parallel) + std::norm(perpendicular));
}

/// The integral of 2 cos F(cos), by the midpoint rule.
template <class Reflectance>
double average(const Reflectance& f) {
  constexpr int steps = 40000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double c = (i + 0.5) / steps;
    sum += 2 * c * f(c) / steps;
  }
  return sum;
}

}  // namespace

TEST_CASE("a dielectric reflects by Fresnel's equations, from both sides") {
  // Floats near the critical angle: the root of a difference keeps half of the digits.
  constexpr double rounding = 5e-4;
  for (const float eta : {0.4f, 0.667f, 0.9f, 1.0f, 1.1f, 1.33f, 1.5f, 2.4f, 10.0f})
    for (int i = 0; i <= 100; ++i) {
      const float c = float(i) / 100;
      CAPTURE(eta, c);
      const double exact = eta == 1 ? 0 : reflectance(c, double(eta));
      CHECK(fresnel_dielectric(c, eta) == Approx(exact).margin(i == 0 ? 1e-6 : rounding * exact));
    }
  CHECK(fresnel_dielectric(1, 1.5f) == Approx(0.04));
  CHECK(fresnel_dielectric(1, 1 / 1.5f) == Approx(0.04));
}

TEST_CASE("total internal reflection begins at the critical angle, Brewster's angle has half a reflection") {
  const float critical = std::sqrt(1 - 1 / (1.5f * 1.5f));
  CHECK(fresnel_dielectric(critical - 1e-4f, 1 / 1.5f) == 1);
  CHECK(fresnel_dielectric(critical + 1e-4f, 1 / 1.5f) < 0.95f);
  CHECK(refracted_cosine(critical - 1e-4f, 1 / 1.5f) == 0);
  // At tan = eta the parallel part vanishes: F = ((1 - eta^2) / (1 + eta^2))^2 / 2.
  const float brewster = 1 / std::sqrt(1 + 1.5f * 1.5f);
  CHECK(fresnel_dielectric(brewster, 1.5f) == Approx(0.5 * std::pow((1 - 2.25) / (1 + 2.25), 2)));
}

TEST_CASE("a boundary reflects the same along a refracted path and back") {
  for (int i = 1; i <= 50; ++i) {
    const float c = float(i) / 50;
    CHECK(fresnel_dielectric(c, 1.5f) ==
          Approx(fresnel_dielectric(refracted_cosine(c, 1.5f), 1 / 1.5f)).margin(2e-5));
  }
}

TEST_CASE("a conductor reflects by Fresnel's equations") {
  for (const float eta : {0.05f, 0.2f, 1.0f, 1.5f, 4.0f})
    for (const float k : {0.1f, 0.5f, 2.0f, 3.9f, 8.0f})
      for (int i = 0; i <= 50; ++i) {
        const float c = float(i) / 50;
        CAPTURE(eta, k, c);
        CHECK(fresnel_conductor(c, eta, k) == Approx(reflectance(c, {eta, k})).margin(2e-6));
      }
  // Normal incidence: ((eta - 1)^2 + k^2) / ((eta + 1)^2 + k^2).
  CHECK(fresnel_conductor(1, 0.2f, 3.9f) == Approx((0.64 + 15.21) / (1.44 + 15.21)));
  CHECK(fresnel_conductor(0, 0.2f, 3.9f) == Approx(1));
}

TEST_CASE("a conductor without absorption is a dielectric, one without a refracted wave a mirror") {
  for (int i = 0; i <= 50; ++i) {
    const float c = float(i) / 50;
    CHECK(fresnel_conductor(c, 1.5f, 0) == Approx(fresnel_dielectric(c, 1.5f)).margin(2e-6));
    CHECK(fresnel_conductor(c, 0, 1) == 1);
    CHECK(std::isfinite(fresnel_conductor(c, 0, 0)));
  }
}

TEST_CASE("averages over the half-space are those of a dense sum") {
  for (const float eta : {1.00005f, 1.001f, 1.1f, 1.33f, 1.5f, 2.0f, 4.0f}) {
    CAPTURE(eta);
    CHECK(average_fresnel_dielectric(eta) ==
          Approx(average([&](double c) { return reflectance(c, double(eta)); })).margin(1e-6));
    const double inside = 1 / double(eta);
    CHECK(average_fresnel_dielectric(float(inside)) ==
          Approx(average([&](double c) { return reflectance(c, inside); })).margin(1e-4));
  }
  CHECK(average_fresnel_dielectric(1) == 0);
  constexpr double stated = 2e-3;
  for (const float eta : {0.05f, 0.2f, 1.0f, 5.0f})
    for (const float k : {0.5f, 2.0f, 8.0f}) {
      CAPTURE(eta, k);
      const double exact = average([&](double c) { return reflectance(c, {eta, k}); });
      CHECK(std::fabs(average_fresnel_conductor({eta, eta, eta}, {k, k, k}).g - exact) <= stated);
    }
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "core/fresnel.h"

#include "core/elementary.h"

namespace twinray {
namespace {

/// Walsh's closed form, for n > 1.
double average_from_outside(double n) {
  constexpr double ln_2 = 0.69314718055994531;
  const double n2 = n * n, n4 = n2 * n2, plus = n2 + 1, minus = n2 - 1;
  const double rational = 0.5 + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) -
                          2 * n * n2 * (n2 + 2 * n - 1) / (plus * (n4 - 1));
  const double first = n2 * minus * minus / (plus * plus * plus) * log2_of((n - 1) / (n + 1));
  const double second = 8 * n4 * (n4 + 1) / (plus * (n4 - 1) * (n4 - 1)) * log2_of(n);
  return rational + ln_2 * (first + second);
}

}  // namespace

float fresnel_conductor(float cos_i, float eta, float k) {
  if (!(cos_i > 0)) return 1;
  const float cos2 = cos_i * cos_i, sin2 = 1 - cos2;
  // (a + i b)^2 = (eta + i k)^2 - sin^2: the refracted wave's cosine times the index.
  const float difference = eta * eta - k * k - sin2;
  const float squares = std::sqrt(difference * difference + 4 * eta * eta * k * k);  // a^2 + b^2
  const float a = std::sqrt(std::max(0.0f, 0.5f * (squares + difference)));
  const float across = 2 * a * cos_i;
  // What is left where both media are alike may be rounded to below 0.
  const float perpendicular = std::max(0.0f, squares + cos2 - across) / (squares + cos2 + across);
  const float along = across * sin2, rest = cos2 * squares + sin2 * sin2;
  if (!(rest + along > 0)) return perpendicular;
  return 0.5f * perpendicular * (1 + std::max(0.0f, rest - along) / (rest + along));
}

float average_fresnel_dielectric(float eta) {
  // Closer to 1 the closed form loses its digits; there the average is below 4e-5 and nearly linear.
  constexpr double least = 1e-4;
  const double n = eta < 1 ? 1 / double(eta) : double(eta);
  const double outside = n - 1 < least ? (n - 1) / least * average_from_outside(1 + least)  //
                                       : average_from_outside(n);
  // What goes out of the denser side comes in from the other, spread over n^2 times the solid angle.
  return float(eta < 1 ? 1 - (1 - outside) / (n * n) : outside);
}

Rgb average_fresnel_conductor(const Rgb& eta, const Rgb& k) {
  return fresnel_conductor(0.21234054f, eta, k) * 0.13965396f +
         fresnel_conductor(0.59053314f, eta, k) * 0.45848221f +
         fresnel_conductor(0.91141204f, eta, k) * 0.40186383f;
}

}  // namespace twinray

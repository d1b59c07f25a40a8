// SPDX-License-Identifier: Apache-2.0
// How much of unpolarised light a smooth boundary reflects (Fresnel's equations), in the directions of the
// boundary's own normal. What is not reflected is refracted by a dielectric, absorbed by a conductor.
#pragma once
#include <algorithm>
#include <cmath>

#include "core/rgb.h"

namespace twinray {

/// The cosine of a refracted direction to the normal, by Snell's law. cos_i in [0, 1]; eta: the index of
/// refraction behind the boundary relative to that of the side the light comes from, > 0. 0 at total internal
/// reflection.
inline float refracted_cosine(float cos_i, float eta) {
  // 1 - sin^2 / eta^2, without the loss of a small cosine where eta is close to 1.
  return std::sqrt(std::max(0.0f, (eta * eta - 1) + cos_i * cos_i)) / eta;
}

/// The reflectance of a dielectric in [0, 1], 1 at total internal reflection. cos_i and eta as above.
inline float fresnel_dielectric(float cos_i, float eta) {
  if (eta == 1) return 0;
  const float cos_t = refracted_cosine(cos_i, eta);
  if (cos_t == 0) return 1;
  const float parallel = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
  const float perpendicular = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
  return 0.5f * (parallel * parallel + perpendicular * perpendicular);
}

/// The reflectance in [0, 1] of a conductor with the complex index of refraction eta + i k, relative to the
/// viewer's side; cos_i in [0, 1], eta >= 0, k >= 0. eta = 0 with k > 0 reflects all.
float fresnel_conductor(float cos_i, float eta, float k);

inline Rgb fresnel_conductor(float cos_i, const Rgb& eta, const Rgb& k) {
  return {fresnel_conductor(cos_i, eta.r, k.r), fresnel_conductor(cos_i, eta.g, k.g),
          fresnel_conductor(cos_i, eta.b, k.b)};
}

/// What a dielectric reflects of light that is the same from all directions of the half-space in front: the
/// integral of 2 cos F(cos) over cos in [0, 1]. Exact (Walsh 1926) to 1e-6. eta as above.
float average_fresnel_dielectric(float eta);

/// The same for a conductor, by three points of Gauss and Jacobi: within 2e-3 for eta in [0.05, 5] and k in
/// [0.5, 8].
Rgb average_fresnel_conductor(const Rgb& eta, const Rgb& k);

}  // namespace twinray

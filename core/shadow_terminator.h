// SPDX-License-Identifier: Apache-2.0
// What a surface whose shading normal leans away from the geometric one keeps of light: it falls to 0
// smoothly where the geometry no longer sees the light, as if facets shaded each other whose normals deviate
// as far as the two do (Estevez, Lecocq and Stein, "A Microfacet-Based Shadowing Function to Solve the Bump
// Terminator Problem", 2019).
#pragma once
#include <algorithm>
#include <cmath>

namespace twinray {

/// tan^2 of an angle by its cosine, of at least 1e-6 or so.
inline float tan_squared(float cosine) {
  const float squared = std::min(cosine * cosine, 1.0f);
  return (1 - squared) / std::max(squared, 1e-12f);
}

/// The square of the alpha of these facets, in [0, 1], by the cosine between both normals, > 0.
inline float terminator_alpha_squared(float cos_normals) {
  return std::min(0.125f * tan_squared(cos_normals), 1.0f);
}

/// The part of light that is left, in [0, 1], by the cosine of its direction to the geometric normal, > 0.
inline float shadow_terminator(float cos_direction, float alpha_squared) {
  return 2 / (1 + std::sqrt(1 + alpha_squared * tan_squared(cos_direction)));
}

}  // namespace twinray

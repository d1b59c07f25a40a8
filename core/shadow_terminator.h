// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>

namespace twinray {

/// What a surface whose shading normal leans away from the geometric one keeps of light from a direction, in
/// [0, 1]: it falls to 0 smoothly where the geometry no longer sees the light, as if facets shaded each other
/// whose normals deviate as far as the two do (Estevez, Lecocq and Stein, "A Microfacet-Based Shadowing
/// Function to Solve the Bump Terminator Problem", 2019). Cosines, > 0, between the geometric normal and the
/// direction, and between both normals.
inline float shadow_terminator(float cos_direction, float cos_normals) {
  const auto tan_squared = [](float cosine) {
    const float squared = std::min(cosine * cosine, 1.0f);
    return (1 - squared) / std::max(squared, 1e-12f);
  };
  const float alpha_squared = std::min(0.125f * tan_squared(cos_normals), 1.0f);
  return 2 / (1 + std::sqrt(1 + alpha_squared * tan_squared(cos_direction)));
}

}  // namespace twinray

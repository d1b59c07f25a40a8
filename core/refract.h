// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#include <optional>

#include "core/vec.h"

namespace twinray {

/// The unit direction on the other side of the plane z = 0 that light from wo is refracted to (Snell); none
/// where all is reflected, or wo lies in the plane. eta: index of refraction on the other side, to that on
/// the side of wo.
inline std::optional<Vec3> refract(const Vec3& wo, float eta) {
  const float sin_squared = (wo.x * wo.x + wo.y * wo.y) / (eta * eta);
  if (sin_squared >= 1 || wo.z == 0) return std::nullopt;
  const float z = std::sqrt(1 - sin_squared);
  return Vec3{-wo.x / eta, -wo.y / eta, wo.z > 0 ? -z : z};
}

}  // namespace twinray

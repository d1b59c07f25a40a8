// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>

#include "core/aabb.h"

namespace twinray {

/// The eight corners of a box that is not empty.
inline std::array<Vec3, 8> corners_of(const Aabb& box) {
  std::array<Vec3, 8> corners;
  for (int i = 0; i < 8; ++i)
    corners[i] = {i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y,
                  i & 4 ? box.upper.z : box.lower.z};
  return corners;
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "core/geometry.h"

namespace twinray {

/// Twice the area of a triangle in texture coordinates: negative where they run the other way round.
inline float uv_area(const std::vector<Vec2>& uvs, const Triangle& t) {
  const Vec2 p = uvs[t[1]] - uvs[t[0]], q = uvs[t[2]] - uvs[t[0]];
  return p.x * q.y - p.y * q.x;
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Private: boxes for Embree's user geometry.
#pragma once
#include "accel/embree/api.h"
#include "accel/embree/rounding.h"
#include "core/aabb.h"
#include "core/geometry.h"

namespace twinray::embree {

/// The largest absolute coordinate of a scene; of an empty one, 0.
inline float scene_size(const Geometry& geometry) {
  const Aabb& box = geometry.bounds();
  return box.is_empty() ? 0 : std::max(max_abs(box.lower), max_abs(box.upper));
}

/// A box padded for Embree, as its interface takes it.
inline RTCBounds widened(const Aabb& box, float scene_size) {
  const auto [lower, upper] = padded_for_embree(box, scene_size);
  return {lower.x, lower.y, lower.z, 0, upper.x, upper.y, upper.z, 0};
}

}  // namespace twinray::embree

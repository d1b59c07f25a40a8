// SPDX-License-Identifier: Apache-2.0
// Private: boxes for Embree's user geometry.
#pragma once
#include <algorithm>

#include "accel/embree/api.h"
#include "accel/embree/rounding.h"
#include "core/aabb.h"
#include "core/geometry.h"
#include "core/instance.h"

namespace twinray::embree {

/// The largest absolute coordinate of a box; of an empty one, 0.
inline float largest_coordinate(const Aabb& box) {
  return box.is_empty() ? 0 : std::max(max_abs(box.lower), max_abs(box.upper));
}

/// That of a scene.
inline float scene_size(const Geometry& geometry) { return largest_coordinate(geometry.bounds()); }

/// In a prototype's space rays begin wherever they begin in the scene, up to so many of its sizes away.
inline constexpr float prototype_reach = 256;

/// What widened() takes for the size of a prototype in this box, so that it widens for such rays.
inline float prototype_size(const Aabb& box) {
  return largest_coordinate(box) * ((1 + prototype_reach) / (1 + reach));
}

/// A box padded for Embree, as its interface takes it.
inline RTCBounds widened(const Aabb& box, float scene_size) {
  const auto [lower, upper] = padded_for_embree(box, scene_size);
  return {lower.x, lower.y, lower.z, 0, upper.x, upper.y, upper.z, 0};
}

/// The box of an instance for Embree's tree over instances. The canonical test sees it widened by the ray's
/// distance (PlacedInstances::far_margin()), and Embree is asked by rays from up to `reach` scene sizes away.
/// `widening` is 1; another factor makes it wrong, to see that tests find it.
inline RTCBounds instance_bounds(const PlacedInstances& placed, std::uint32_t instance, float scene_size,
                                 float widening) {
  const Aabb& box = placed[instance].box;
  if (box.is_empty()) return widened({{}, {}}, 0);
  const float pad = placed.far_margin() * reach * scene_size;
  const Aabb seen{box.lower - Vec3{pad, pad, pad}, box.upper + Vec3{pad, pad, pad}};
  return widened(seen, std::max(scene_size, largest_coordinate(seen)) * widening);
}

}  // namespace twinray::embree

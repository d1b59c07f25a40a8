// SPDX-License-Identifier: Apache-2.0
// Private: one ray through an eight-wide BVH, in the obvious way: one box after the other by the canonical
// test, the nearest child first. It is the oracle of the fast kernels, and it counts.
#pragma once
#include <algorithm>
#include <cstdint>

#include "accel/canonical/slab.h"
#include "accel/counters.h"
#include "accel/wide/node.h"

namespace twinray {

/// Bit i: the ray intersects the box of child i within [ray.t_min, t_max]; it enters it at entries[i], at
/// least t_min.
inline std::uint32_t intersect_children(const WideNode& node, const CheckedRay& ray, float t_max,
                                        float entries[WideNode::width]) {
  std::uint32_t met = 0;
  for (int child = 0; child < WideNode::width; ++child) {
    const SlabInterval interval = intersect_slab(ray, node.box(child));
    entries[child] = std::max(interval.near, ray.t_min);
    met |= std::uint32_t(entries[child] <= std::min(interval.far, t_max)) << child;
  }
  return met;
}

/// The least accepted hit, or a miss; what it took is added to `counts`. An invalid ray is a miss.
Hit scalar_closest(const WideBvh& bvh, const Geometry& geometry, const Ray& given, QueryCounts& counts);

/// Whether scalar_closest would find a hit.
bool scalar_any(const WideBvh& bvh, const Geometry& geometry, const Ray& given, QueryCounts& counts);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Private: one ray through an eight-wide BVH, in the obvious way: one box after the other by the canonical
// test, the nearest child first. It is the oracle of the fast kernels, and it counts.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "accel/canonical/slab.h"
#include "accel/counters.h"
#include "accel/wide/kernel.h"
#include "accel/wide/node.h"

namespace twinray {

/// Bit i: the ray intersects the box of child i within [ray.t_min, t_max]; it enters it at entries[i], at
/// least t_min.
template <typename Node>
std::uint32_t intersect_children(const Node& node, const CheckedRay& ray, float t_max,
                                 float entries[WideNode::width]) {
  std::uint32_t met = 0;
  for (int child = 0; child < node.count(); ++child) {
    const SlabInterval interval = intersect_slab(ray, node.box(child));
    entries[child] = std::max(interval.near, ray.t_min);
    met |= std::uint32_t(entries[child] <= std::min(interval.far, t_max)) << child;
  }
  return met;
}

/// The least accepted hit, or a miss; what it took is added to `counts`. An invalid ray is a miss. Tree:
/// WideBvh or CompactBvh.
template <typename Tree>
Hit scalar_closest(const Tree& bvh, const Geometry& geometry, const Ray& given, QueryCounts& counts);

/// Whether scalar_closest would find a hit.
template <typename Tree>
bool scalar_any(const Tree& bvh, const Geometry& geometry, const Ray& given, QueryCounts& counts);

/// The scalar traversal as a kernel.
template <typename Tree>
class ScalarKernel {
 public:
  static BasicWideKernel<Tree> kernel() {
    return {"scalar",      closest,   any,        closest_batch, any_batch,
            closest_batch, any_batch, no_packets, load_ray,      intersect_children<typename Tree::Node>};
  }

 private:
  static Hit closest(const Tree& bvh, const Geometry& geometry, const Ray& ray) {
    QueryCounts counts;
    return scalar_closest(bvh, geometry, ray, counts);
  }
  static bool any(const Tree& bvh, const Geometry& geometry, const Ray& ray) {
    QueryCounts counts;
    return scalar_any(bvh, geometry, ray, counts);
  }
  static void closest_batch(const Tree& bvh, const Geometry& geometry, std::span<const Ray> rays, Hit* hits) {
    for (const Ray& ray : rays) *hits++ = closest(bvh, geometry, ray);
  }
  static void any_batch(const Tree& bvh, const Geometry& geometry, std::span<const Ray> rays,
                        std::uint8_t* hits) {
    for (const Ray& ray : rays) *hits++ = any(bvh, geometry, ray);
  }
  static std::size_t no_packets(const Tree&, const Geometry&, std::span<const Ray>, Hit*) { return 0; }
};

}  // namespace twinray

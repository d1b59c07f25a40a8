// SPDX-License-Identifier: Apache-2.0
// Private: the traversals of the eight-wide BVH: one for each instruction set, and a scalar one, their
// oracle. All give the same bits.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "accel/canonical/checked_ray.h"
#include "accel/counters.h"
#include "accel/wide/node.h"
#include "core/geometry.h"
#include "core/hit.h"

namespace twinray {

/// The queries over a tree of a geometry, of which Tree is the kind: WideBvh or CompactBvh. An invalid ray is
/// a miss. Counts: none, or QueryCounts& to which each query adds its own steps.
template <typename Tree, typename... Counts>
struct BasicWideKernel {
  std::string name;  ///< Of the instruction set: "avx512", "avx2", "sse4", "scalar".
  Hit (*closest)(const Tree&, const Geometry&, const Ray&, Counts...);
  bool (*any)(const Tree&, const Geometry&, const Ray&, Counts...);
  /// The same of many rays, one after the other.
  void (*closest_in_turn)(const Tree&, const Geometry&, std::span<const Ray>, Hit* hits, Counts...);
  void (*any_in_turn)(const Tree&, const Geometry&, std::span<const Ray>, std::uint8_t* hits, Counts...);
  /// The same of many rays, several at a time.
  void (*closest_batch)(const Tree&, const Geometry&, std::span<const Ray>, Hit* hits, Counts...);
  void (*any_batch)(const Tree&, const Geometry&, std::span<const Ray>, std::uint8_t* hits, Counts...);
  /// The closest hits of the first rays, sixteen at a time, as long as they run close together; how many rays
  /// that are. Their bits are those of closest().
  std::size_t (*closest_in_packets)(const Tree&, const Geometry&, std::span<const Ray>, Hit* hits, Counts...);
  /// The bits of load_ray().
  bool (*load)(const Ray&, CheckedRay&);
  /// The box test alone. Bit i: the ray intersects the box of child i within [ray.t_min, t_max]; it enters it
  /// at entries[i], at least t_min.
  std::uint32_t (*intersect_children)(const typename Tree::Node&, const CheckedRay&, float t_max,
                                      float entries[WideNode::width]);
};

/// Whether a scene has instances: what knows that it has none is faster.
enum class WideTrees { plain, instanced };

inline WideTrees trees_of(const Geometry& geometry) {
  return geometry.has_instances() ? WideTrees::instanced : WideTrees::plain;
}

/// The kernels that this machine can run, the fastest first and the scalar one last.
using WideKernel = BasicWideKernel<WideBvh>;
std::vector<WideKernel> wide_kernels(WideTrees trees = WideTrees::plain);

/// Those of them that are compiled for an instruction set, from the same source, but counting: so a test can
/// hold the steps of the fast traversals against those of the scalar one.
using CountingWideKernel = BasicWideKernel<WideBvh, QueryCounts&>;
std::vector<CountingWideKernel> counting_wide_kernels(WideTrees trees = WideTrees::plain);

}  // namespace twinray

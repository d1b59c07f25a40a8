// SPDX-License-Identifier: Apache-2.0
// Private: our leaf as Embree calls it: blocks of primitives as user geometry.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "accel/canonical/nearest.h"
#include "accel/counters.h"
#include "accel/embree/device.h"

namespace twinray::embree {

/// A query on its way through Embree.
struct LeafQuery : Context {
  const PrimitiveBlock* const blocks;
  const Geometry& geometry;
  const CheckedRay& ray;
  const float t_far_scale;  ///< Multiplies a hit's t into a tfar.
  QueryCounts* const counts;
  Nearest best;         ///< What a closest-hit query found.
  bool is_hit = false;  ///< What an any-hit query found.

  // A constructor, for an aggregate is filled with zeros first.
  LeafQuery(const PrimitiveBlock* all, const Geometry& shapes, const CheckedRay& checked, float scale,
            QueryCounts* sums)
      : blocks(all), geometry(shapes), ray(checked), t_far_scale(scale), counts(sums) {
    initialize(*this);
  }
  /// The block that Embree asks for, counted.
  const PrimitiveBlock& enter(unsigned index) {
    const PrimitiveBlock& block = blocks[index];
    if (counts) {
      ++counts->leaves;
      counts->primitives += block.count;
    }
    return block;
  }
  /// Tells Embree of the least hit so far.
  void shorten(RTCRayHit& ray_hit) const { shorten(best.t, ray_hit); }
  /// Tells it of a hit at t, if there is one.
  void shorten(float t, RTCRayHit& ray_hit) const {
    if (t <= ray.t_max) ray_hit.ray.tfar = std::min(ray_hit.ray.tfar, t * t_far_scale + 0.0f);
  }
  /// Tells Embree that an any-hit query is answered.
  void end_if_hit(RTCRay& ended) const {
    if (is_hit) ended.tfar = -Aabb::infinity;
  }
};

/// The callbacks for one instruction set; Embree's context is a LeafQuery, its primitives are the blocks.
struct LeafFunctions {
  std::string name;  ///< Of the instruction set, as WideKernel's.
  RTCIntersectFunctionN intersect;
  RTCOccludedFunctionN occlude;
};

/// Those that this machine can run, the fastest first and the scalar ones last.
std::vector<LeafFunctions> leaf_functions();

}  // namespace twinray::embree

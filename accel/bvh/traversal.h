// SPDX-License-Identifier: Apache-2.0
// Private: the way of one ray through a binary BVH, nearer child first.
//
// Both boxes of a pair are tested at once by accel/canonical/slab.h's operations: of each axis, two lanes
// hold where the ray crosses the near planes of both children, two where it crosses the far ones. The bits
// are those of intersect_slab, so what its monotony promises holds: no box is culled that holds an accepted
// hit.
#pragma once
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "accel/build/binary_tree.h"
#include "accel/bvh/node.h"
#include "accel/canonical/instance_ray.h"
#include "accel/counting.h"
#include "core/lanes.h"

namespace twinray {

/// Where a ray enters both children, at least t_min, and leaves them, at most t_max.
struct PairIntervals {
  Float4 entries;     ///< Of the first and the second child; two lanes without a meaning.
  Float4 exits;       ///< Two lanes without a meaning; of the first and the second child.
  std::uint32_t met;  ///< Bit i: the entry into child i does not lie behind its exit.

  float entry(int child) const { return entries[child]; }
};

/// A ray in the form that the pair test needs: in lanes, with its octant as offsets into a row of planes.
class PairRay {
 public:
  explicit PairRay(const CheckedRay& ray) : t_min_(ray.t_min) {
    for (int axis = 0; axis < 3; ++axis) {
      const float near = ray.near_origin[axis], far = ray.far_origin[axis];
      const float near_inverse = ray.near_inverse[axis], far_inverse = ray.far_inverse[axis];
      origin_[axis] = Float4{near, near, far, far};
      inverse_[axis] = Float4{near_inverse, near_inverse, far_inverse, far_inverse};
      near_offset_[axis] = ray.is_negative[axis] ? 2 : 0;
    }
  }
  PairIntervals intersect(const NodePair& pair, float t_max) const {
    const Float4 x = at_planes(pair, 0), y = at_planes(pair, 1), z = at_planes(pair, 2);
    const Float4 entries = max(max(x, y), max(z, splat(t_min_)));
    const Float4 exits = min(min(x, y), min(z, splat(t_max)));
    const Int4 met = entries <= __builtin_shufflevector(exits, exits, 2, 3, 2, 3);
    return {entries, exits, mask_bits(met) & 3};
  }

 private:
  /// The parameters at which the ray crosses the planes of one axis that are near in its direction, of the
  /// first and the second child, and the far ones.
  Float4 at_planes(const NodePair& pair, int axis) const {
    const float* const row = pair.planes[axis];
    std::int64_t near, far;
    std::memcpy(&near, row + near_offset_[axis], sizeof near);
    std::memcpy(&far, row + (2 - near_offset_[axis]), sizeof far);
    return (Float4(Long2{near, far}) - origin_[axis]) * inverse_[axis];
  }

  Float4 origin_[3], inverse_[3];
  std::ptrdiff_t near_offset_[3];
  float t_min_;
};

/// The siblings that a traversal has still to visit; at most one a level.
class TraversalStack {
 public:
  void push(const NodeRef& node, float entry) {
    entries_[size_] = entry;
    nodes_[size_++] = std::bit_cast<std::uint64_t>(node);
  }
  /// Takes the latest node that the ray enters at t_max or before; false where there is none.
  bool pop(float t_max, NodeRef& node) {
    while (size_ > 0) {
      --size_;
      if (entries_[size_] > t_max) continue;
      node = std::bit_cast<NodeRef>(nodes_[size_]);
      return true;
    }
    return false;
  }

 private:
  int size_ = 0;
  float entries_[max_bvh_depth];
  std::uint64_t nodes_[max_bvh_depth];  ///< NodeRefs; as numbers they need not be initialised.
};

/// Calls `visit(leaf)` for all leaves whose boxes the ray intersects between ray.t_min and t_max, about front
/// to back; `visit` may lower t_max, and ends the traversal by returning true. Whether it did.
template <typename Visit, typename Counts>
bool traverse_leaves(const Bvh& bvh, const CheckedRay& ray, const float& t_max, Counts counts,
                     Visit&& visit) {
  counts.test_box();
  const SlabInterval root = intersect_slab(ray, bvh.box);
  if (root.near > root.far || root.near > t_max || root.far < ray.t_min) return false;
  const PairRay pair_ray(ray);
  TraversalStack stack;
  NodeRef node = bvh.root;
  do {
    while (!node.is_leaf()) {
      const NodePair& pair = bvh.pairs[node.first];
      counts.visit_node(pair);
      const PairIntervals intervals = pair_ray.intersect(pair, t_max);
      if (intervals.met == 0) {
        if (!stack.pop(t_max, node)) return false;
      } else if (intervals.met != 3) {
        node = pair.children[intervals.met >> 1];
      } else {
        const int nearer = intervals.entry(1) < intervals.entry(0), farther = 1 - nearer;
        stack.push(pair.children[farther], intervals.entry(farther));
        node = pair.children[nearer];
      }
    }
    counts.visit_leaf();
    if (visit(node)) return true;
  } while (stack.pop(t_max, node));
  return false;
}

/// The same with `test(block)` for each block of the leaves.
template <typename Test, typename Counts>
bool traverse(const Bvh& bvh, const CheckedRay& ray, const float& t_max, Counts counts, Test&& test) {
  return traverse_leaves(bvh, ray, t_max, counts, [&](const NodeRef& leaf) {
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
      const PrimitiveBlock& block = bvh.blocks[leaf.first + i];
      counts.test_block(block);
      if (test(block)) return true;
    }
    return false;
  });
}

/// All trees of a scene: calls `test(own, block)`, `own` being the ray in the space of the block.
template <typename Test, typename Counts>
bool traverse_scene(const SceneBvh& all, const Geometry& geometry, const CheckedRay& ray, const float& t_max,
                    Counts counts, Test&& test) {
  if (traverse(all.direct, ray, t_max, counts, [&](const PrimitiveBlock& block) { return test(ray, block); }))
    return true;
  if (all.instance_order.empty()) return false;
  return traverse_leaves(all.instances, ray, t_max, counts, [&](const NodeRef& leaf) {
    const std::uint32_t instance = all.instance_order[leaf.first];
    CheckedRay own;
    if (!enter_instance(geometry.placed(), instance, ray, t_max, own)) return false;
    counts.enter_instance();
    float own_t_max = own.t_max;
    const Bvh& prototype = all.prototypes[geometry.instances()[instance].prototype];
    return traverse(prototype, own, own_t_max, counts, [&](const PrimitiveBlock& block) {
      const bool is_done = test(own, block);
      own_t_max = std::min(own_t_max, t_max);
      return is_done;
    });
  });
}

}  // namespace twinray

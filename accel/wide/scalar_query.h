// SPDX-License-Identifier: Apache-2.0
// Private: the scalar traversal of either tree; compiled in instantiations.cpp.
#pragma once
#include "accel/wide/scalar.h"

#include <algorithm>

#include "accel/canonical/instance_ray.h"

namespace twinray {
namespace {

/// A child that waits for its turn.
struct Waiting {
  float entry;
  std::uint32_t ref;
};

/// The nearer is the earlier; of equally near ones the lesser name, as in the fast kernels.
inline bool is_later(const Waiting& a, const Waiting& b) {
  return a.entry != b.entry ? a.entry > b.entry : a.ref > b.ref;
}

/// Calls `test(leaf)` for the leaves whose boxes the ray intersects between ray.t_min and t_max, in the order
/// of the fast kernels: for the closest hit about front to back, for any hit as the children come, but the
/// last of the waiting ones first. `test` may lower t_max, and ends the traversal by returning true. Whether
/// it did.
template <QueryKind kind, typename Tree, typename Test>
bool traverse_scalar(const Tree& bvh, WideRef root, const CheckedRay& ray, const float& t_max,
                     QueryCounts& counts, Test&& test) {
  Waiting stack[wide_stack_size + WideNode::width];
  int size = 0;
  if (!root.is_none()) stack[size++] = {ray.t_min, root.bits};
  while (size > 0) {
    const Waiting next = stack[--size];
    const WideRef ref{next.ref};
    if (next.entry > t_max) continue;
    if (ref.is_leaf()) {
      ++counts.leaves;
      if (test(ref)) return true;
      continue;
    }
    ++counts.nodes;
    const typename Tree::Node& node = bvh.node(ref);
    counts.boxes += std::uint64_t(node.count());
    float entries[WideNode::width];
    const std::uint32_t met = intersect_children(node, ray, t_max, entries);
    Waiting* const children = stack + size;
    for (int child = 0; child < WideNode::width; ++child)
      if (met >> child & 1) stack[size++] = {entries[child], node.children[child].bits};
    if (kind == QueryKind::closest)
      std::sort(children, stack + size, is_later);
    else if (met != 0)
      std::rotate(children, children + 1, stack + size);
  }
  return false;
}

/// One query: the blocks that it tests, of the scene and of instances.
template <QueryKind kind, typename Tree>
class ScalarQuery {
 public:
  ScalarQuery(const Tree& bvh, const Geometry& geometry, const CheckedRay& ray, QueryCounts& counts)
      : bvh_(bvh), geometry_(geometry), ray_(ray), counts_(counts), t_max_(ray.t_max) {}

  /// The least accepted hit; of QueryKind::any, one of them.
  Hit find() {
    traverse_scalar<kind>(bvh_, bvh_.root, ray_, t_max_, counts_, [&](WideRef leaf) {
      return leaf.is_instance() ? visit_instance(leaf.index()) : visit_block(ray_, leaf);
    });
    return best_;
  }

 private:
  bool visit_block(const CheckedRay& ray, WideRef leaf) {
    const PrimitiveBlock& block = bvh_.block(leaf);
    counts_.primitives += block.count;
    test_block<kind>(geometry_, ray, block, best_);
    if (kind == QueryKind::closest) t_max_ = std::min(t_max_, best_.t);
    return kind == QueryKind::any && best_;
  }
  bool visit_instance(std::uint32_t instance) {
    CheckedRay own;
    if (!enter_instance(geometry_.placed(), instance, ray_, t_max_, own)) return false;
    ++counts_.instances;
    float own_t_max = own.t_max;
    const WideRef root = bvh_.prototypes[geometry_.instances()[instance].prototype];
    return traverse_scalar<kind>(bvh_, root, own, own_t_max, counts_, [&](WideRef leaf) {
      const bool is_done = visit_block(own, leaf);
      own_t_max = std::min(own_t_max, t_max_);
      return is_done;
    });
  }

  const Tree& bvh_;
  const Geometry& geometry_;
  const CheckedRay& ray_;
  QueryCounts& counts_;
  float t_max_;
  Hit best_;
};

}  // namespace

template <typename Tree>
Hit scalar_closest(const Tree& bvh, const Geometry& geometry, const Ray& given, QueryCounts& counts) {
  return closest_of(geometry, given, [&](const CheckedRay& ray) {
    return ScalarQuery<QueryKind::closest, Tree>(bvh, geometry, ray, counts).find();
  });
}

template <typename Tree>
bool scalar_any(const Tree& bvh, const Geometry& geometry, const Ray& given, QueryCounts& counts) {
  return any_of(geometry, given, [&](const CheckedRay& ray) {
    return bool(ScalarQuery<QueryKind::any, Tree>(bvh, geometry, ray, counts).find());
  });
}

}  // namespace twinray

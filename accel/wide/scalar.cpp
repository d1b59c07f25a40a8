// SPDX-License-Identifier: Apache-2.0
// Out of line: what counts must not make the queries that do not count any slower.
#include "accel/wide/scalar.h"

#include <algorithm>

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

/// Calls `test(block)` for the blocks whose boxes the ray intersects between ray.t_min and t_max, in the
/// order of the fast kernels: for the closest hit about front to back, for any hit as the children come, but
/// the last of the waiting ones first. `test` may lower t_max, and ends the traversal by returning true.
template <QueryKind kind, typename Test>
void traverse_scalar(const WideBvh& bvh, const CheckedRay& ray, const float& t_max, QueryCounts& counts,
                     Test&& test) {
  Waiting stack[wide_stack_size];
  int size = 0;
  if (!bvh.root.is_none()) stack[size++] = {ray.t_min, bvh.root.bits};
  while (size > 0) {
    const Waiting next = stack[--size];
    const WideRef ref{next.ref};
    if (next.entry > t_max) continue;
    if (ref.is_block()) {
      const PrimitiveBlock& block = bvh.blocks[ref.index()];
      ++counts.leaves;
      counts.primitives += block.count;
      if (test(block)) return;
      continue;
    }
    ++counts.nodes;
    const WideNode& node = bvh.nodes[ref.index()];
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
}

}  // namespace

Hit scalar_closest(const WideBvh& bvh, const Geometry& geometry, const Ray& given, QueryCounts& counts) {
  Hit best;
  CheckedRay ray;
  if (!load_ray(given, ray)) return best;
  float t_max = ray.t_max;
  traverse_scalar<QueryKind::closest>(bvh, ray, t_max, counts, [&](const PrimitiveBlock& block) {
    test_block<QueryKind::closest>(geometry, ray, block, best);
    t_max = std::min(t_max, best.t);
    return false;
  });
  ray.scale_back(best);
  return best;
}

bool scalar_any(const WideBvh& bvh, const Geometry& geometry, const Ray& given, QueryCounts& counts) {
  Hit found;
  CheckedRay ray;
  if (!load_ray(given, ray)) return false;
  traverse_scalar<QueryKind::any>(bvh, ray, ray.t_max, counts, [&](const PrimitiveBlock& block) {
    test_block<QueryKind::any>(geometry, ray, block, found);
    return !found.is_miss();
  });
  return !found.is_miss();
}

}  // namespace twinray

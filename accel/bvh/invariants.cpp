// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/invariants.h"

#include <fmt/format.h>

#include "accel/build/binary_tree.h"

namespace twinray {
namespace {

class Inspection {
 public:
  Inspection(const Bvh& bvh, const Geometry& geometry, int max_leaf_size)
      : bvh_(bvh), max_leaf_size_(max_leaf_size), leaves_(geometry) {}

  std::string fault(const Geometry& geometry, Occurrence occurrence) {
    if (geometry.primitive_count() > 0) visit(bvh_.root, bvh_.box, 0);
    return fault_.empty() ? leaves_.fault(occurrence) : fault_;
  }

 private:
  template <typename... Values>
  void report(fmt::format_string<Values...> text, Values&&... values) {
    if (fault_.empty()) fault_ = fmt::format(text, std::forward<Values>(values)...);
  }

  void visit(const NodeRef& node, const Aabb& box, int depth) {
    if (depth > max_bvh_depth) return report("a node is {} deep; the stack holds {}", depth, max_bvh_depth);
    if (node.is_leaf()) return visit_leaf(node, box);
    if (node.first >= bvh_.pairs.size())
      return report("pair {} is named, of {}", node.first, bvh_.pairs.size());
    const NodePair& pair = bvh_.pairs[node.first];
    for (int child = 0; child < 2; ++child) {
      if (!box.contains(pair.box(child))) report("child {} of pair {} leaves its parent", child, node.first);
      visit(pair.children[child], pair.box(child), depth + 1);
    }
  }

  void visit_leaf(const NodeRef& node, const Aabb& box) {
    int primitives = 0;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (i >= bvh_.blocks.size()) return report("block {} is named, of {}", i, bvh_.blocks.size());
      for (std::uint32_t lane = 0; lane < bvh_.blocks[i].count; ++lane, ++primitives)
        if (const std::string fault = leaves_.add(bvh_.blocks[i].ids[lane], box); !fault.empty())
          report("{}", fault);
    }
    if (primitives == 0 || primitives > max_leaf_size_) report("a leaf holds {} primitives", primitives);
  }

  const Bvh& bvh_;
  int max_leaf_size_;
  LeavesOfPrimitives leaves_;
  std::string fault_;
};

}  // namespace

std::string find_fault(const Bvh& bvh, const Geometry& geometry, int max_leaf_size, Occurrence occurrence) {
  return Inspection(bvh, geometry, max_leaf_size).fault(geometry, occurrence);
}

}  // namespace twinray

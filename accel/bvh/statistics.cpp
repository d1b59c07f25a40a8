// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/statistics.h"

#include <algorithm>

#include "accel/build/cost_model.h"

namespace twinray {
namespace {

class Survey {
 public:
  Survey(const Bvh& bvh, const CostModel& cost, TreeStats& stats) : bvh_(bvh), cost_(cost), stats_(stats) {}

  /// `probability`: that a ray which intersects the root intersects this node.
  void visit(const NodeRef& node, double probability, double area, int depth) {
    ++stats_.nodes;
    stats_.depth = std::max(stats_.depth, depth);
    if (node.is_leaf()) return visit_leaf(node, probability);
    stats_.sah_cost += probability * cost_.traversal();
    const NodePair& pair = bvh_.pairs[node.first];
    for (int child = 0; child < 2; ++child) {
      const double child_area = pair.box(child).half_area();
      visit(pair.children[child], area > 0 ? probability * child_area / area : probability, child_area,
            depth + 1);
    }
  }

 private:
  void visit_leaf(const NodeRef& node, double probability) {
    ++stats_.leaves;
    std::size_t primitives = 0;
    for (std::uint32_t i = 0; i < node.count; ++i) primitives += bvh_.blocks[node.first + i].count;
    stats_.sah_cost += probability * cost_.leaf(primitives);
  }

  const Bvh& bvh_;
  const CostModel& cost_;
  TreeStats& stats_;
};

}  // namespace

TreeStats statistics_of(const Bvh& bvh, const BuildOptions& options) {
  TreeStats stats;
  if (bvh.blocks.empty()) return stats;
  const CostModel cost(options);
  Survey(bvh, cost, stats).visit(bvh.root, 1, bvh.box.half_area(), 0);
  return stats;
}

}  // namespace twinray

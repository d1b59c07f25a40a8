// SPDX-License-Identifier: Apache-2.0
#include "accel/wide/statistics.h"

#include <algorithm>

#include "accel/build/cost_model.h"

namespace twinray {
namespace {

class Survey {
 public:
  Survey(const WideBvh& bvh, const CostModel& cost, TreeStats& stats)
      : bvh_(bvh), cost_(cost), stats_(stats) {}

  /// `probability`: that a ray that intersects the root intersects this node, whose box has half the area
  /// `area`.
  void visit(const WideRef& ref, double probability, double area, int depth) {
    ++stats_.nodes;
    stats_.depth = std::max(stats_.depth, depth);
    if (ref.is_block()) {
      ++stats_.leaves;
      stats_.sah_cost += probability * cost_.leaf(bvh_.blocks[ref.index()].count);
      return;
    }
    stats_.sah_cost += probability * cost_.traversal();
    const WideNode& node = bvh_.nodes[ref.index()];
    for (int child = 0; child < node.count(); ++child) {
      const double child_area = node.box(child).half_area();
      visit(node.children[child], area > 0 ? probability * child_area / area : probability, child_area,
            depth + 1);
    }
  }

  double root_area() const {
    Aabb box;
    if (!bvh_.nodes.empty())
      for (int child = 0; child < WideNode::width; ++child) box.extend(bvh_.nodes[0].box(child));
    return box.half_area();
  }

 private:
  const WideBvh& bvh_;
  const CostModel& cost_;
  TreeStats& stats_;
};

}  // namespace

TreeStats statistics_of(const WideBvh& bvh, const BuildOptions& options) {
  TreeStats stats;
  if (bvh.root.is_none()) return stats;
  const CostModel cost(options);
  Survey survey(bvh, cost, stats);
  survey.visit(bvh.root, 1, survey.root_area(), 0);
  return stats;
}

}  // namespace twinray

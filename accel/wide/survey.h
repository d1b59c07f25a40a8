// SPDX-License-Identifier: Apache-2.0
// Private: the statistics of either tree; compiled in instantiations.cpp.
#pragma once
#include "accel/wide/statistics.h"

#include <algorithm>
#include <vector>

#include "accel/build/cost_model.h"

namespace twinray {
namespace {

/// What the trees of prototypes cost a ray.
struct InstanceCosts {
  const Geometry& geometry;
  std::vector<double> prototypes;

  double of(std::uint32_t instance) const { return prototypes[geometry.instances()[instance].prototype]; }
};

template <typename Tree>
class Survey {
 public:
  /// `prototypes`: what each instance's prototype's tree costs a ray.
  Survey(const Tree& bvh, const CostModel& cost, const InstanceCosts& instances, TreeStats& stats)
      : bvh_(bvh), cost_(cost), instances_(instances), stats_(stats) {}

  /// `probability`: that a ray that intersects the root intersects this node, whose box has half the area
  /// `area`.
  void visit(const WideRef& ref, double probability, double area, int depth) {
    ++stats_.nodes;
    stats_.depth = std::max(stats_.depth, depth);
    if (ref.is_leaf()) {
      ++stats_.leaves;
      stats_.sah_cost += probability * leaf_cost(ref);
      return;
    }
    stats_.sah_cost += probability * cost_.traversal();
    const typename Tree::Node& node = bvh_.node(ref);
    for (int child = 0; child < node.count(); ++child) {
      const double child_area = node.box(child).half_area();
      visit(node.children[child], area > 0 ? probability * child_area / area : probability, child_area,
            depth + 1);
    }
  }

  double area_of(const WideRef& root) const {
    Aabb box;
    if (!root.is_leaf())
      for (int child = 0; child < bvh_.node(root).count(); ++child) box.extend(bvh_.node(root).box(child));
    return box.half_area();
  }

 private:
  double leaf_cost(const WideRef& leaf) const {
    if (leaf.is_instance()) return cost_.traversal() + instances_.of(leaf.index());
    return cost_.leaf(bvh_.block(leaf).count);
  }

  const Tree& bvh_;
  const CostModel& cost_;
  const InstanceCosts& instances_;
  TreeStats& stats_;
};

}  // namespace

template <typename Tree>
TreeStats statistics_of(const Tree& bvh, const Geometry& geometry, const BuildOptions& options) {
  const CostModel cost(options);
  InstanceCosts instances{geometry, {}};
  const auto survey = [&](const WideRef& root) {
    TreeStats stats;
    Survey of_tree(bvh, cost, instances, stats);
    if (!root.is_none()) of_tree.visit(root, 1, of_tree.area_of(root), 0);
    return stats;
  };
  TreeStats below;
  for (const WideRef& root : bvh.prototypes) {
    const TreeStats prototype = survey(root);
    instances.prototypes.push_back(prototype.sah_cost);
    below.nodes += prototype.nodes;
    below.leaves += prototype.leaves;
    below.depth = std::max(below.depth, prototype.depth + 1);
  }
  const TreeStats scene = survey(bvh.root);
  return {scene.nodes + below.nodes, scene.leaves + below.leaves, scene.depth + below.depth, scene.sah_cost};
}

}  // namespace twinray

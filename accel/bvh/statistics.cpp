// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/statistics.h"

#include <algorithm>
#include <vector>

#include "accel/build/cost_model.h"

namespace twinray {
namespace {

/// The cost of a leaf, by what it is.
class LeafCost {
 public:
  LeafCost(const SceneBvh& all, const Geometry& geometry, const CostModel& cost)
      : all_(all), geometry_(geometry), cost_(cost) {}

  double operator()(const Bvh& bvh, const NodeRef& leaf) const {
    if (&bvh == &all_.instances) return cost_.traversal() + of_instance(all_.instance_order[leaf.first]);
    std::size_t primitives = 0;
    for (std::uint32_t i = 0; i < leaf.count; ++i) primitives += bvh.blocks[leaf.first + i].count;
    return cost_.leaf(primitives);
  }
  /// What is added when a prototype's tree has been surveyed, in their order.
  void add_prototype(double cost) { prototypes_.push_back(cost); }

 private:
  double of_instance(std::uint32_t instance) const {
    return prototypes_[geometry_.instances()[instance].prototype];
  }

  const SceneBvh& all_;
  const Geometry& geometry_;
  const CostModel& cost_;
  std::vector<double> prototypes_;
};

class Survey {
 public:
  Survey(const Bvh& bvh, const CostModel& cost, const LeafCost& leaf, TreeStats& stats)
      : bvh_(bvh), cost_(cost), leaf_(leaf), stats_(stats) {}

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
    stats_.sah_cost += probability * leaf_(bvh_, node);
  }

  const Bvh& bvh_;
  const CostModel& cost_;
  const LeafCost& leaf_;
  TreeStats& stats_;
};

}  // namespace

TreeStats statistics_of(const SceneBvh& all, const Geometry& geometry, const BuildOptions& options) {
  const CostModel cost(options);
  LeafCost leaf(all, geometry, cost);
  const auto survey = [&](const Bvh& bvh, double area) {
    TreeStats stats;
    const double own = bvh.box.half_area();
    if (!bvh.box.is_empty())
      Survey(bvh, cost, leaf, stats).visit(bvh.root, area > 0 ? own / area : 1, own, 0);
    return stats;
  };
  TreeStats prototypes;
  for (const Bvh& bvh : all.prototypes) {
    const TreeStats one = survey(bvh, bvh.box.half_area());
    leaf.add_prototype(one.sah_cost);
    prototypes.nodes += one.nodes;
    prototypes.leaves += one.leaves;
    prototypes.depth = std::max(prototypes.depth, one.depth + 1);
  }
  Aabb box = all.direct.box;
  box.extend(all.instances.box);
  const TreeStats direct = survey(all.direct, box.half_area());
  const TreeStats instances = survey(all.instances, box.half_area());
  return {prototypes.nodes + direct.nodes + instances.nodes,
          prototypes.leaves + direct.leaves + instances.leaves,
          std::max(direct.depth, instances.depth + prototypes.depth), direct.sah_cost + instances.sah_cost};
}

}  // namespace twinray

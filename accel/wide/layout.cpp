// SPDX-License-Identifier: Apache-2.0
#include "accel/wide/layout.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "accel/canonical/slab.h"
#include "accel/wide/collapse.h"
#include "accel/wide/occlusion.h"
#include "core/parallel.h"

namespace twinray {
namespace {

/// How many nodes or blocks a task makes.
constexpr std::size_t items_per_task = 2048;

/// The primitives of a leaf.
struct Leaf {
  std::uint32_t count = 0;
  std::array<PrimitiveId, PrimitiveBlock::width> ids;
};

/// The places of nodes and blocks, depth first.
class Layout {
 public:
  explicit Layout(const BuildTree& tree) : tree_(tree) {}

  WideRef place(const CollapsePlan& plan, std::uint32_t binary) {
    if (plan.is_leaf(binary)) {
      leaves_.push_back(binary);
      return WideRef::block(leaves_.size() - 1);
    }
    const std::size_t index = nodes_.size();
    nodes_.push_back({binary, plan.children(binary), {}});
    for (int child = 0; child < nodes_[index].children.count; ++child)
      nodes_[index].refs[child] = place(plan, nodes_[index].children.nodes[child]);
    return WideRef::node(index);
  }

  void make_blocks(const Geometry& geometry, BigVector<PrimitiveBlock>& blocks) {
    blocks.resize(leaves_.size());
    of_blocks_.resize(leaves_.size());
    parallel_for(blocks.size(), items_per_task, 0, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        Leaf leaf;
        collect(leaves_[i], leaf);
        blocks[i] = make_block(geometry, std::span(leaf.ids).first(leaf.count));
        of_blocks_[i] = prospect_of(geometry, blocks[i], half_area(leaves_[i]));
      }
    });
  }

  /// Leaves that stand for other trees, one each, instead of blocks.
  void make_links() {
    // What such a tree hides is not known; to ask it takes a few steps.
    constexpr Prospect prospect{.occlusion = 0.25f, .cost = 4};
    of_blocks_.assign(leaves_.size(), prospect);
  }
  /// The number of such a leaf's tree.
  std::uint32_t link(WideRef leaf) const {
    return tree_.primitives[tree_.nodes[leaves_[leaf.index()]].first].id.primitive;
  }

  /// Behind make_blocks or make_links.
  void make_nodes(BigVector<WideNode>& nodes) {
    order_children();
    nodes.resize(nodes_.size());
    parallel_for(nodes.size(), items_per_task, 0, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) nodes[i] = make_node(nodes_[i]);
    });
  }

 private:
  struct PlacedNode {
    std::uint32_t binary = 0;
    CollapsePlan::Children children;
    WideRef refs[WideNode::width];
  };

  double half_area(std::uint32_t binary) const { return tree_.nodes[binary].box.half_area(); }

  /// From the last node to the first, for children come behind their parents.
  void order_children() {
    std::vector<Prospect> of_nodes(nodes_.size());
    for (std::size_t i = nodes_.size(); i-- > 0;) {
      PlacedNode& node = nodes_[i];
      const int count = node.children.count;
      Candidate candidates[WideNode::width];
      for (int child = 0; child < count; ++child) {
        const WideRef ref = node.refs[child];
        const Prospect& prospect = (ref.is_leaf() ? of_blocks_ : of_nodes)[ref.index()];
        candidates[child] = {node.children.nodes[child], ref, half_area(node.children.nodes[child]),
                             prospect};
      }
      const std::span used = std::span(candidates).first(std::size_t(count));
      sort_for_occlusion(used);
      of_nodes[i] = prospect_of(used, half_area(node.binary));
      for (int child = 0; child < count; ++child) {
        node.children.nodes[child] = candidates[child].binary;
        node.refs[child] = candidates[child].ref;
      }
    }
  }
  WideNode make_node(const PlacedNode& placed) const {
    WideNode node;
    for (int child = 0; child < placed.children.count; ++child) {
      node.set_box(child, padded(tree_.nodes[placed.children.nodes[child]].box));
      node.children[child] = placed.refs[child];
    }
    return node;
  }
  void collect(std::uint32_t binary, Leaf& leaf) const {
    const BuildTree::Node& node = tree_.nodes[binary];
    for (std::uint32_t i = 0; i < node.count; ++i)
      leaf.ids[leaf.count++] = tree_.primitives[node.first + i].id;
    if (node.count > 0) return;
    collect(node.first, leaf);
    collect(node.first + 1, leaf);
  }

  const BuildTree& tree_;
  std::vector<PlacedNode> nodes_;
  std::vector<std::uint32_t> leaves_;  ///< Binary nodes.
  std::vector<Prospect> of_blocks_;
};

}  // namespace

WideBvh widen(const BuildTree& tree, const Geometry& geometry, int max_leaf_size) {
  WideBvh bvh;
  if (tree.primitives.empty()) return bvh;
  Layout layout(tree);
  bvh.root = layout.place(CollapsePlan(tree, max_leaf_size), 0);  // Here the plan's memory is free again.
  layout.make_blocks(geometry, bvh.blocks);
  layout.make_nodes(bvh.nodes);
  return bvh;
}

WideBvh widen_above(const BuildTree& tree) {
  WideBvh bvh;
  if (tree.primitives.empty()) return bvh;
  Layout layout(tree);
  bvh.root = layout.place(CollapsePlan(tree, 1), 0);
  layout.make_links();
  layout.make_nodes(bvh.nodes);
  const auto link = [&](WideRef& ref) {
    if (ref.is_leaf() && !ref.is_none()) ref = WideRef::instance(layout.link(ref));
  };
  for (WideNode& node : bvh.nodes)
    for (WideRef& child : node.children) link(child);
  link(bvh.root);
  return bvh;
}

}  // namespace twinray

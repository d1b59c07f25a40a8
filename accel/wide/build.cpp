// SPDX-License-Identifier: Apache-2.0
#include "accel/wide/build.h"

#include <algorithm>
#include <array>

#include "accel/build/phase_timer.h"
#include "accel/build/reinsertion.h"
#include "accel/builders.h"
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

  /// Leaves of one instance each, instead of blocks.
  void make_instances() {
    // What an instance hides is not known; to ask its tree takes a few steps.
    constexpr Prospect prospect{.occlusion = 0.25f, .cost = 4};
    of_blocks_.assign(leaves_.size(), prospect);
  }
  /// The instance of such a leaf.
  WideRef instance(WideRef leaf) const {
    return WideRef::instance(tree_.primitives[tree_.nodes[leaves_[leaf.index()]].first].id.primitive);
  }

  /// Behind make_blocks or make_instances.
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

/// What the binary tree is built with: leaves that fit into a block, and costs that fill them.
BuildOptions binary_options(BuildOptions options) {
  options.max_leaf_size = std::min(options.max_leaf_size, PrimitiveBlock::width);
  options.leaf_block = PrimitiveBlock::width;
  if (options.bvh_quality == BvhQuality::fast) options.bvh_bins = std::min(options.bvh_bins, 16);
  return options;
}

/// Almost all that can be won is won with the largest nodes. More rounds over all nodes make rooms slower:
/// their walls and rods come to share boxes, by the area alone at no loss.
ReinsertionEffort effort_of(BvhQuality quality) {
  switch (quality) {
    case BvhQuality::fast:
      return {.rounds = 2, .share = 0.01};
    case BvhQuality::medium:
      return {.rounds = 2, .share = 0.05};
    default:
      return {.rounds = 2, .share = 1};
  }
}

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

namespace {

/// A tree and the box of all that is in it.
struct BoxedBvh {
  WideBvh bvh;
  Aabb box;
};

Aabb box_of(const BuildTree& tree) { return tree.nodes.empty() ? Aabb{} : tree.nodes[0].box; }

/// Of a tree of instances with leaves of one each.
WideBvh widen_instances(const BuildTree& tree) {
  WideBvh bvh;
  if (tree.primitives.empty()) return bvh;
  Layout layout(tree);
  bvh.root = layout.place(CollapsePlan(tree, 1), 0);
  layout.make_instances();
  layout.make_nodes(bvh.nodes);
  for (WideNode& node : bvh.nodes)
    for (WideRef& child : node.children)
      if (child.is_leaf() && !child.is_none()) child = layout.instance(child);
  if (bvh.root.is_leaf()) bvh.root = layout.instance(bvh.root);
  return bvh;
}

BoxedBvh make_tree_of(const Geometry& geometry, ShapeRange shapes, const BuildOptions& options,
                      std::vector<BuildPhase>& phases) {
  BoxedBvh made;
  BuildPrimitives primitives;
  BuildTree tree;
  const BuildOptions binary = binary_options(options);
  timed("boxes", phases, [&] { primitives = collect_primitives(geometry, shapes); });
  timed("tree", phases, [&] { tree = build_by(std::move(primitives), binary); });
  timed("reinsertion", phases, [&] { reinsert(tree, effort_of(options.bvh_quality)); });
  timed("collapse", phases, [&] { made.bvh = widen(tree, geometry, binary.max_leaf_size); });
  made.box = box_of(tree);
  return made;
}

BoxedBvh make_instance_tree(const Geometry& geometry, const BuildOptions& options) {
  BuildOptions binary = binary_options(options);
  binary.max_leaf_size = 1;
  BuildTree tree = build_tree(collect_instances(geometry), binary);
  reinsert(tree, effort_of(options.bvh_quality));
  return {widen_instances(tree), box_of(tree)};
}

/// Moves a tree's nodes and blocks behind those of others, and frees it; returns its root there.
WideRef append(WideBvh bvh, WideBvh& all) {
  const std::size_t nodes = all.nodes.size(), blocks = all.blocks.size();
  const auto moved = [&](WideRef ref) {
    if (ref.is_none() || (ref.is_leaf() && ref.is_instance())) return ref;
    return ref.is_leaf() ? WideRef::block(blocks + ref.index()) : WideRef::node(nodes + ref.index());
  };
  for (WideNode& node : bvh.nodes)
    for (WideRef& child : node.children) child = moved(child);
  all.nodes.reserve(nodes + bvh.nodes.size() + 1);  // With room for the root of join().
  all.nodes.insert(all.nodes.end(), bvh.nodes.begin(), bvh.nodes.end());
  all.blocks.insert(all.blocks.end(), bvh.blocks.begin(), bvh.blocks.end());
  return moved(bvh.root);
}

/// The root above two trees, of which either may be empty.
WideRef join(WideRef first, const Aabb& first_box, WideRef second, const Aabb& second_box, WideBvh& all) {
  if (first.is_none() || second.is_none()) return first.is_none() ? second : first;
  WideNode node;
  node.children[0] = first;
  node.set_box(0, padded(first_box));
  node.children[1] = second;
  node.set_box(1, padded(second_box));
  all.nodes.push_back(node);
  return WideRef::node(all.nodes.size() - 1);
}

/// Trees of all prototypes, side by side, behind what is there already.
void add_prototypes(const Geometry& geometry, const BuildOptions& options, WideBvh& all) {
  std::vector<WideBvh> prototypes(geometry.prototypes().size());
  parallel_for(prototypes.size(), 1, 0, [&](std::size_t begin, std::size_t end) {
    std::vector<BuildPhase> phases;  // Those of trees that are built at the same time add up to nothing.
    for (std::size_t i = begin; i < end; ++i)
      prototypes[i] = make_tree_of(geometry, geometry.prototypes()[i], options, phases).bvh;
  });
  std::size_t nodes = all.nodes.size(), blocks = all.blocks.size();
  for (const WideBvh& prototype : prototypes)
    nodes += prototype.nodes.size(), blocks += prototype.blocks.size();
  all.nodes.reserve(nodes + 1);
  all.blocks.reserve(blocks);
  for (WideBvh& prototype : prototypes) all.prototypes.push_back(append(std::move(prototype), all));
}

/// The trees of the prototypes, and the tree of the scene above them.
WideBvh make_trees(const Geometry& geometry, const BuildOptions& options, std::vector<BuildPhase>& phases) {
  auto [all, direct_box] = make_tree_of(geometry, geometry.direct_shapes(), options, phases);
  if (!geometry.has_instances()) return std::move(all);
  timed("prototypes", phases, [&] { add_prototypes(geometry, options, all); });
  timed("instances", phases, [&] {
    BoxedBvh instances = make_instance_tree(geometry, options);
    const WideRef root = append(std::move(instances.bvh), all);
    all.root = join(all.root, direct_box, root, instances.box, all);
  });
  return std::move(all);
}

}  // namespace

WideBvh make_wide_bvh(const Geometry& geometry, const BuildOptions& options,
                      std::vector<BuildPhase>& phases) {
  WideBvh bvh;
  with_threads(options.threads, [&] { bvh = make_trees(geometry, options, phases); });
  return bvh;
}

}  // namespace twinray

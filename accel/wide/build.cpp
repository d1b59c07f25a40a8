// SPDX-License-Identifier: Apache-2.0
#include "accel/wide/build.h"

#include <algorithm>
#include <array>

#include "accel/bvh/reinsertion.h"
#include "accel/phase_timer.h"
#include "accel/wide/collapse.h"
#include "core/parallel.h"
#include "core/slab.h"

namespace twinray {
namespace {

/// How many blocks a task makes.
constexpr std::size_t blocks_per_task = 4096;

/// Most of what can be won is, in a tenth of the time of the whole build.
constexpr ReinsertionEffort effort{.rounds = 2, .share = 0.2};

/// The primitives of a leaf.
struct Leaf {
  std::uint32_t count = 0;
  std::array<PrimitiveId, TriangleBlock::width> ids;
};

/// Appends nodes depth first, and what their leaves hold.
class Layout {
 public:
  Layout(const BuildTree& tree, const CollapsePlan& plan, std::vector<WideNode>& nodes)
      : tree_(tree), plan_(plan), nodes_(nodes) {}

  WideRef add(std::uint32_t binary) {
    if (plan_.is_leaf(binary)) {
      collect(binary, leaves_.emplace_back());
      return WideRef::block(leaves_.size() - 1);
    }
    const std::size_t index = nodes_.size();
    nodes_.emplace_back();
    const CollapsePlan::Children children = plan_.children(binary);
    for (int child = 0; child < children.count; ++child) {
      const WideRef ref = add(children.nodes[child]);
      nodes_[index].children[child] = ref;
      nodes_[index].set_box(child, padded(tree_.nodes[children.nodes[child]].box));
    }
    return WideRef::node(index);
  }
  const std::vector<Leaf>& leaves() const { return leaves_; }

 private:
  void collect(std::uint32_t binary, Leaf& leaf) const {
    const BuildTree::Node& node = tree_.nodes[binary];
    for (std::uint32_t i = 0; i < node.count; ++i)
      leaf.ids[leaf.count++] = tree_.primitives[node.first + i].id;
    if (node.count > 0) return;
    collect(node.first, leaf);
    collect(node.first + 1, leaf);
  }

  const BuildTree& tree_;
  const CollapsePlan& plan_;
  std::vector<WideNode>& nodes_;
  std::vector<Leaf> leaves_;
};

/// What the binary tree is built with: leaves that fit into a block, and costs that fill them.
BuildOptions binary_options(BuildOptions options) {
  options.max_leaf_size = std::min(options.max_leaf_size, TriangleBlock::width);
  options.leaf_block = TriangleBlock::width;
  return options;
}

}  // namespace

WideBvh widen(const BuildTree& tree, const Geometry& geometry, int max_leaf_size) {
  WideBvh bvh;
  if (tree.primitives.empty()) return bvh;
  const CollapsePlan plan(tree, max_leaf_size);
  Layout layout(tree, plan, bvh.nodes);
  bvh.root = layout.add(0);
  bvh.nodes.shrink_to_fit();
  const std::vector<Leaf>& leaves = layout.leaves();
  bvh.blocks.resize(leaves.size());
  parallel_for(leaves.size(), blocks_per_task, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      bvh.blocks[i] = make_block(geometry, std::span(leaves[i].ids).first(leaves[i].count));
  });
  return bvh;
}

WideBvh make_wide_bvh(const Geometry& geometry, const BuildOptions& options,
                      std::vector<BuildPhase>& phases) {
  WideBvh bvh;
  const BuildOptions binary = binary_options(options);
  with_threads(options.threads, [&] {
    std::vector<BuildPrimitive> primitives;
    BuildTree tree;
    timed("boxes", phases, [&] { primitives = collect_primitives(geometry); });
    timed("tree", phases, [&] { tree = build_by(std::move(primitives), binary); });
    timed("reinsertion", phases, [&] { reinsert(tree, effort); });
    timed("collapse", phases, [&] { bvh = widen(tree, geometry, binary.max_leaf_size); });
  });
  return bvh;
}

}  // namespace twinray

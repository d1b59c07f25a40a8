// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/build.h"

#include <algorithm>
#include <array>
#include <utility>

#include "accel/build/phase_timer.h"
#include "accel/builders.h"
#include "accel/canonical/slab.h"
#include "core/parallel.h"

namespace twinray {
namespace {

/// How many blocks a task makes.
constexpr std::size_t blocks_per_task = 4096;

/// The primitives of one block.
struct BlockRange {
  std::uint32_t first, count;
};

/// Appends nodes depth first, and the ranges of their blocks.
class Layout {
 public:
  Layout(const BuildTree& tree, Bvh& bvh) : tree_(tree), bvh_(bvh) {}

  NodeRef add(const BuildTree::Node& node) {
    if (node.count > 0) return add_leaf(node);
    const std::size_t pair = bvh_.pairs.size();
    bvh_.pairs.emplace_back();
    for (std::uint32_t child = 0; child < 2; ++child) {
      const BuildTree::Node& child_node = tree_.nodes[node.first + child];
      const NodeRef ref = add(child_node);
      bvh_.pairs[pair].set_box(int(child), padded(child_node.box));
      bvh_.pairs[pair].children[child] = ref;
    }
    return {std::uint32_t(pair), 0};
  }
  const std::vector<BlockRange>& block_ranges() const { return block_ranges_; }

 private:
  NodeRef add_leaf(const BuildTree::Node& node) {
    const std::size_t first = block_ranges_.size();
    for (std::uint32_t done = 0; done < node.count; done += PrimitiveBlock::width)
      block_ranges_.push_back(
          {node.first + done, std::min<std::uint32_t>(PrimitiveBlock::width, node.count - done)});
    return {std::uint32_t(first), std::uint32_t(block_ranges_.size() - first)};
  }

  const BuildTree& tree_;
  Bvh& bvh_;
  std::vector<BlockRange> block_ranges_;
};

PrimitiveBlock make_block(const BuildTree& tree, const BlockRange& range, const Geometry& geometry) {
  std::array<PrimitiveId, PrimitiveBlock::width> ids;
  for (std::uint32_t i = 0; i < range.count; ++i) ids[i] = tree.primitives[range.first + i].id;
  return make_block(geometry, std::span(ids).first(range.count));
}

}  // namespace

Bvh lay_out(const BuildTree& tree, const Geometry& geometry) {
  Bvh bvh;
  if (tree.primitives.empty()) return bvh;
  bvh.box = padded(tree.nodes[0].box);
  Layout layout(tree, bvh);
  bvh.root = layout.add(tree.nodes[0]);
  bvh.pairs.shrink_to_fit();
  const std::vector<BlockRange>& ranges = layout.block_ranges();
  bvh.blocks.resize(ranges.size());
  parallel_for(ranges.size(), blocks_per_task, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) bvh.blocks[i] = make_block(tree, ranges[i], geometry);
  });
  return bvh;
}

namespace {

Bvh make_bvh_of(const Geometry& geometry, ShapeRange shapes, const BuildOptions& options,
                std::vector<BuildPhase>& phases) {
  Bvh bvh;
  with_threads(options.threads, [&] {
    BuildPrimitives primitives;
    BuildTree tree;
    timed("boxes", phases, [&] { primitives = collect_primitives(geometry, shapes); });
    timed("tree", phases, [&] { tree = build_by(std::move(primitives), options); });
    timed("layout", phases, [&] { bvh = lay_out(tree, geometry); });
  });
  return bvh;
}

/// A tree over instances: its leaves have one each, and no blocks.
void make_instance_tree(const Geometry& geometry, BuildOptions options, SceneBvh& all) {
  options.max_leaf_size = 1;
  const BuildTree tree = build_tree(collect_instances(geometry), options);
  if (tree.primitives.empty()) return;
  all.instances.box = padded(tree.nodes[0].box);
  Layout layout(tree, all.instances);
  all.instances.root = layout.add(tree.nodes[0]);
  for (const BlockRange& leaf : layout.block_ranges())
    all.instance_order.push_back(tree.primitives[leaf.first].id.primitive);
}

}  // namespace

Bvh make_bvh(const Geometry& geometry, const BuildOptions& options, std::vector<BuildPhase>& phases) {
  return make_bvh_of(geometry, geometry.direct_shapes(), options, phases);
}

SceneBvh make_scene_bvh(const Geometry& geometry, const BuildOptions& options,
                        std::vector<BuildPhase>& phases) {
  SceneBvh all{.direct = make_bvh(geometry, options, phases)};
  for (const ShapeRange& prototype : geometry.prototypes())
    all.prototypes.push_back(make_bvh_of(geometry, prototype, options, phases));
  if (geometry.has_instances())
    timed("instances", phases,
          [&] { with_threads(options.threads, [&] { make_instance_tree(geometry, options, all); }); });
  return all;
}

}  // namespace twinray

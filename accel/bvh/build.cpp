// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/build.h"

#include <fmt/format.h>

#include <array>

#include "accel/embree/builder.h"
#include "accel/phase_timer.h"
#include "core/error.h"
#include "core/parallel.h"
#include "core/slab.h"

namespace twinray {
namespace {

constexpr std::size_t max_primitives = std::size_t{1} << 30;
/// Subtrees below this size are not worth a task.
constexpr std::size_t task_size = 4096;

class TreeBuilder {
 public:
  TreeBuilder(BuildTree& tree, const BuildOptions& options) : tree_(tree), options_(options) {}

  /// Makes node `index` over the primitives [first, first + count).
  void build(std::uint32_t index, std::size_t first, std::size_t count, int depth) {
    const NodeRange range(std::span(tree_.primitives).subspan(first, count));
    BuildTree::Node& node = tree_.nodes[index];
    node.box = range.box;
    const std::size_t left = count == 1 ? 0 : divide_at(range, depth);
    if (left == 0) {
      node.first = std::uint32_t(first);
      node.count = std::uint32_t(count);
      return;
    }
    const std::uint32_t child = std::uint32_t(2 * (first + left) - 1);
    node.first = child;
    const auto build_first = [&] { build(child, first, left, depth + 1); };
    const auto build_second = [&] { build(child + 1, first + left, count - left, depth + 1); };
    if (count >= task_size) return parallel_invoke(build_first, build_second);
    build_first();
    build_second();
  }

 private:
  std::size_t divide_at(const NodeRange& range, int depth) const {
    if (depth < free_bvh_depth) return divide(range, options_);
    return range.primitives.size() <= std::size_t(options_.max_leaf_size) ? 0 : divide_by_median(range);
  }

  BuildTree& tree_;
  const BuildOptions& options_;
};

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
    for (std::uint32_t done = 0; done < node.count; done += TriangleBlock::width)
      block_ranges_.push_back(
          {node.first + done, std::min<std::uint32_t>(TriangleBlock::width, node.count - done)});
    return {std::uint32_t(first), std::uint32_t(block_ranges_.size() - first)};
  }

  const BuildTree& tree_;
  Bvh& bvh_;
  std::vector<BlockRange> block_ranges_;
};

TriangleBlock make_block(const BuildTree& tree, const BlockRange& range, const Geometry& geometry) {
  std::array<PrimitiveId, TriangleBlock::width> ids;
  for (std::uint32_t i = 0; i < range.count; ++i) ids[i] = tree.primitives[range.first + i].id;
  return make_block(geometry, std::span(ids).first(range.count));
}

}  // namespace

std::vector<BuildPrimitive> collect_primitives(const Geometry& geometry) {
  if (geometry.primitive_count() > max_primitives)
    throw Error(fmt::format("the scene has {} primitives; a BVH takes up to {}", geometry.primitive_count(),
                            max_primitives));
  std::vector<BuildPrimitive> primitives;
  primitives.reserve(geometry.primitive_count());
  for (std::uint32_t shape = 0; shape < geometry.shapes().size(); ++shape) {
    const Mesh* mesh = geometry.mesh(shape);
    const std::size_t count = mesh ? mesh->triangles.size() : geometry.sphere_set(shape)->spheres.size();
    for (std::uint32_t i = 0; i < count; ++i)
      primitives.push_back({primitive_bounds(geometry, {shape, i}), {shape, i}});
  }
  return primitives;
}

BuildTree build_tree(std::vector<BuildPrimitive> primitives, const BuildOptions& options) {
  BuildTree tree;
  tree.primitives = std::move(primitives);
  const std::size_t count = tree.primitives.size();
  if (count == 0) return tree;
  tree.nodes.resize(2 * count - 1);
  TreeBuilder(tree, options).build(0, 0, count, 0);
  return tree;
}

void halve_subtree(BuildTree& tree, const BuildOptions& options, std::uint32_t index, std::size_t first,
                   std::size_t count) {
  TreeBuilder(tree, options).build(index, first, count, free_bvh_depth);
}

BuildTree build_by(std::vector<BuildPrimitive> primitives, const BuildOptions& options) {
  if (options.bvh_builder == BvhBuilder::own) return build_tree(std::move(primitives), options);
#ifdef TWINRAY_WITH_EMBREE
  return build_tree_by_embree(std::move(primitives), options);
#else
  throw Error(fmt::format("the builder {} is not part of this build", builder_name(options.bvh_builder)));
#endif
}

Bvh lay_out(const BuildTree& tree, const Geometry& geometry) {
  Bvh bvh;
  if (tree.primitives.empty()) return bvh;
  bvh.box = padded(tree.nodes[0].box);
  Layout layout(tree, bvh);
  bvh.root = layout.add(tree.nodes[0]);
  bvh.pairs.shrink_to_fit();
  const std::vector<BlockRange>& ranges = layout.block_ranges();
  bvh.blocks.resize(ranges.size());
  parallel_for(ranges.size(), task_size, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) bvh.blocks[i] = make_block(tree, ranges[i], geometry);
  });
  return bvh;
}

Bvh make_bvh(const Geometry& geometry, const BuildOptions& options, std::vector<BuildPhase>& phases) {
  Bvh bvh;
  with_threads(options.threads, [&] {
    std::vector<BuildPrimitive> primitives;
    BuildTree tree;
    timed("boxes", phases, [&] { primitives = collect_primitives(geometry); });
    timed("tree", phases, [&] { tree = build_by(std::move(primitives), options); });
    timed("layout", phases, [&] { bvh = lay_out(tree, geometry); });
  });
  return bvh;
}

}  // namespace twinray

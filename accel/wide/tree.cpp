// SPDX-License-Identifier: Apache-2.0
#include "accel/wide/tree.h"

#include <algorithm>

#include "accel/build/phase_timer.h"
#include "accel/build/reinsertion.h"
#include "accel/builders.h"
#include "accel/wide/layout.h"

namespace twinray {
namespace {

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

Aabb box_of(const BuildTree& tree) { return tree.nodes.empty() ? Aabb{} : tree.nodes[0].box; }

}  // namespace

BuildOptions binary_options(BuildOptions options) {
  options.max_leaf_size = std::min(options.max_leaf_size, PrimitiveBlock::width);
  options.leaf_block = PrimitiveBlock::width;
  if (options.bvh_quality == BvhQuality::fast) options.bvh_bins = std::min(options.bvh_bins, 16);
  return options;
}

BoxedBvh<WideBvh> make_tree(const Geometry& geometry, BuildPrimitives primitives, const BuildOptions& options,
                            std::vector<BuildPhase>& phases) {
  BoxedBvh<WideBvh> made;
  BuildTree tree;
  const BuildOptions binary = binary_options(options);
  timed("tree", phases, [&] { tree = build_by(std::move(primitives), binary); });
  timed("reinsertion", phases, [&] { reinsert(tree, effort_of(options.bvh_quality)); });
  timed("collapse", phases, [&] { made.bvh = widen(tree, geometry, binary.max_leaf_size); });
  made.box = box_of(tree);
  return made;
}

BoxedBvh<WideBvh> make_instance_tree(const Geometry& geometry, const BuildOptions& options) {
  BuildOptions binary = binary_options(options);
  binary.max_leaf_size = 1;
  BuildTree tree = build_tree(collect_instances(geometry), binary);
  reinsert(tree, effort_of(options.bvh_quality));
  return {widen_above(tree), box_of(tree)};
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Private: the trees of a geometry put together: those of its prototypes, side by side, and that of the scene
// above them. Tree: WideBvh or CompactBvh.
#pragma once
#include <functional>
#include <utility>
#include <vector>

#include "accel/build/big_vector.h"
#include "accel/build/phase_timer.h"
#include "accel/canonical/slab.h"
#include "accel/wide/tree.h"
#include "core/parallel.h"

namespace twinray {

/// Makes the tree of some shapes of a geometry, and adds how long its steps took.
template <typename Tree>
using TreeMaker = std::function<BoxedBvh<Tree>(ShapeRange, std::vector<BuildPhase>&)>;

/// Moves a tree's nodes and blocks behind those of others, and frees it; returns its root there.
template <typename Tree>
WideRef append(Tree bvh, Tree& all) {
  const std::size_t nodes = all.nodes.size(), blocks = all.block_places();
  const auto moved = [&](WideRef ref) {
    if (ref.is_none() || (ref.is_leaf() && ref.is_instance())) return ref;
    return ref.is_leaf() ? WideRef::block(blocks + ref.index()) : WideRef::node(nodes + ref.index());
  };
  for (typename Tree::Node& node : bvh.nodes)
    for (WideRef& child : node.children) child = moved(child);
  all.nodes.insert(all.nodes.end(), bvh.nodes.begin(), bvh.nodes.end());
  all.blocks.insert(all.blocks.end(), bvh.blocks.begin(), bvh.blocks.end());
  // An allocator would keep it for what comes, of which there is little.
  release_memory(bvh.nodes.data(), bvh.nodes.size());
  release_memory(bvh.blocks.data(), bvh.blocks.size());
  return moved(bvh.root);
}

/// Trees one behind the other, behind what is there already; returns their roots. Each is freed as soon as
/// it has moved, so that nothing is twice in memory for long. There is room for `more` nodes then.
template <typename Tree>
std::vector<WideRef> append_all(std::vector<Tree> trees, Tree& all, std::size_t more) {
  std::size_t nodes = all.nodes.size() + more, blocks = all.blocks.size();
  for (const Tree& tree : trees) nodes += tree.nodes.size(), blocks += tree.blocks.size();
  all.nodes.reserve(nodes);
  all.blocks.reserve(blocks);
  std::vector<WideRef> roots;
  for (Tree& tree : trees) roots.push_back(append(std::exchange(tree, {}), all));
  return roots;
}

/// The root above two trees, of which either may be empty.
template <typename Tree>
WideRef join(WideRef first, const Aabb& first_box, WideRef second, const Aabb& second_box, Tree& all) {
  if (first.is_none() || second.is_none()) return first.is_none() ? second : first;
  WideNode node;
  node.children[0] = first;
  node.set_box(0, padded(first_box));
  node.children[1] = second;
  node.set_box(1, padded(second_box));
  all.nodes.push_back(typename Tree::Node(node));
  return WideRef::node(all.nodes.size() - 1);
}

/// The trees of all prototypes behind what is there already.
template <typename Tree>
void add_prototypes(const Geometry& geometry, const TreeMaker<Tree>& make, std::size_t more, Tree& all) {
  std::vector<Tree> prototypes(geometry.prototypes().size());
  parallel_for(prototypes.size(), 1, 0, [&](std::size_t begin, std::size_t end) {
    std::vector<BuildPhase> phases;  // Those of trees that are built at the same time add up to nothing.
    for (std::size_t i = begin; i < end; ++i) prototypes[i] = make(geometry.prototypes()[i], phases).bvh;
  });
  all.prototypes = append_all(std::move(prototypes), all, more);
}

/// The trees of the prototypes, and the tree of the scene above them.
template <typename Tree>
Tree make_forest(const Geometry& geometry, const BuildOptions& options, const TreeMaker<Tree>& make,
                 std::vector<BuildPhase>& phases) {
  BoxedBvh<Tree> direct = make(geometry.direct_shapes(), phases);
  Tree& all = direct.bvh;
  if (!geometry.has_instances()) return std::move(all);
  BoxedBvh<WideBvh> instances;
  timed("instances", phases, [&] { instances = make_instance_tree(geometry, options); });
  timed("prototypes", phases, [&] { add_prototypes(geometry, make, instances.bvh.nodes.size() + 1, all); });
  const WideRef root = append(Tree(std::move(instances.bvh)), all);
  all.root = join(all.root, direct.box, root, instances.box, all);
  return std::move(all);
}

}  // namespace twinray

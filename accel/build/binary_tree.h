// SPDX-License-Identifier: Apache-2.0
// Private: from a geometry to a finished tree.
#pragma once
#include <vector>

#include "accel/accelerator.h"
#include "accel/build/split.h"
#include "accel/bvh/node.h"

namespace twinray {

/// A binary tree over an array of primitives before it is laid out for traversal.
struct BuildTree {
  struct Node {
    Aabb box;
    std::uint32_t first = 0;  ///< Leaf: its first primitive. Inner: its first child; the second follows.
    std::uint32_t count = 0;  ///< Leaf: its primitives. Inner: 0.
  };
  using Nodes = BigVector<Node>;
  Nodes nodes;  ///< The root, then pairs of children, in an order that no thread changes.
  /// By a builder that splits primitives, pieces of them: a primitive comes once for each of its pieces,
  /// whose boxes together cover its padded box as accel/bvh/invariants.h has it.
  BuildPrimitives primitives;
};

/// All primitives of a geometry, in the order of their ids. Throws Error for more than 2^30.
BuildPrimitives collect_primitives(const Geometry& geometry);

/// Divides until every node is a leaf; on as many threads as with_threads allows. The same tree on any number
/// of them.
BuildTree build_tree(BuildPrimitives primitives, const BuildOptions& options);

/// Makes node `index` of a tree, which lies at the depth free_bvh_depth, over the primitives
/// [first, first + count), and all below it: halves down to leaves of up to options.max_leaf_size.
void halve_subtree(BuildTree& tree, const BuildOptions& options, std::uint32_t index, std::size_t first,
                   std::size_t count);

/// The same by the builder of the options. Throws Error where that is not part of this build.
BuildTree build_by(BuildPrimitives primitives, const BuildOptions& options);

/// Lays a tree out for traversal: pads boxes, copies vertices into blocks.
Bvh lay_out(const BuildTree& tree, const Geometry& geometry);

/// All three steps, with the builder of the options, on options.threads threads; adds how long each took to
/// `phases`. Throws Error where the builder is not part of this build.
Bvh make_bvh(const Geometry& geometry, const BuildOptions& options, std::vector<BuildPhase>& phases);

}  // namespace twinray

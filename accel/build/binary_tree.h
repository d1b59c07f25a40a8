// SPDX-License-Identifier: Apache-2.0
// Private: a binary tree over the primitives of a geometry, from which the trees of both widths are made.
#pragma once
#include <cstdint>

#include "accel/build/split.h"

namespace twinray {

/// Inner nodes lie at depths below max_bvh_depth, so a traversal that keeps one sibling a level fits a stack
/// of that size. Up to free_bvh_depth the split method decides; below, halving the primitives does, which
/// ends after 32 levels for any count of 32 bits.
inline constexpr int free_bvh_depth = 64;
inline constexpr int max_bvh_depth = free_bvh_depth + 32;

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
  /// whose boxes together cover its padded box as accel/build/coverage.h has it.
  BuildPrimitives primitives;
};

/// All primitives of some shapes of a geometry, in the order of their ids. Throws Error where the geometry
/// has more than 2^30.
BuildPrimitives collect_primitives(const Geometry& geometry, ShapeRange shapes);

/// The instances of a geometry that can be hit, as primitives whose ids are their numbers. Throws Error for
/// more than 2^30.
BuildPrimitives collect_instances(const Geometry& geometry);

/// Divides until every node is a leaf; on as many threads as with_threads allows. The same tree on any number
/// of them.
BuildTree build_tree(BuildPrimitives primitives, const BuildOptions& options);

/// Makes node `index` of a tree, which lies at the depth free_bvh_depth, over the primitives
/// [first, first + count), and all below it: halves down to leaves of up to options.max_leaf_size.
void halve_subtree(BuildTree& tree, const BuildOptions& options, std::uint32_t index, std::size_t first,
                   std::size_t count);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Private: which nodes of a binary tree become the nodes and leaves of an eight-wide one, at the least cost.
//
// After Ylitie, Karras and Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs",
// High Performance Graphics 2017. Let cost(n, i) be the least cost of the subtree of n as a forest of at most
// i trees. Of one tree it is a leaf's, or that of a wide node over a forest of eight; of more, the least sum
// over all ways to divide i among the two children of n. The tables are filled from the leaves up.
#pragma once
#include <cstdint>
#include <vector>

#include "accel/build/binary_tree.h"
#include "accel/wide/node.h"

namespace twinray {

class CollapsePlan {
 public:
  /// Indices of binary nodes.
  struct Children {
    int count = 0;
    std::uint32_t nodes[WideNode::width];
  };

  /// For a tree with primitives, whose leaves hold at most max_leaf_size, 1 to 4, and so will those of the
  /// plan; on as many threads as with_threads allows.
  CollapsePlan(const BuildTree& tree, int max_leaf_size);

  /// The probability that a ray that intersects the root intersects a binary node: their areas' ratio; 1 for
  /// a root without area.
  float probability(std::uint32_t node) const {
    return root_area_ > 0 ? float(tree_.nodes[node].box.half_area() / root_area_) : 1;
  }

  /// The cost of a wide node that a ray intersects, and of a leaf with its block of up to four primitives.
  /// Any leaf_cost from 0.6 to 3 gave the same speed within the noise.
  static constexpr float node_cost = 1, leaf_cost = 0.9f;

  /// The expected cost of such a ray for the whole tree.
  float cost() const { return entries_[0].cost[0]; }
  /// Whether the whole subtree of a binary node becomes one leaf.
  bool is_leaf(std::uint32_t node) const;
  /// The binary nodes, 2 to 8, that become the children of the wide node in the place of this one.
  Children children(std::uint32_t node) const;

 private:
  static constexpr int max_trees = WideNode::width - 1;
  struct Entry {
    float cost[max_trees];     ///< [i - 1]: as a forest of at most i trees.
    std::uint32_t primitives;  ///< In the subtree.
  };

  void fill(std::uint32_t node, int depth);
  void fill_inner(std::uint32_t node);
  float distributed(const BuildTree::Node& node, int trees) const;
  int first_trees(const BuildTree::Node& node, int trees) const;
  void divide(std::uint32_t node, int trees, Children& children) const;
  void gather(std::uint32_t node, int trees, Children& children) const;

  const BuildTree& tree_;
  std::uint32_t max_leaf_size_;
  double root_area_;
  BigVector<Entry> entries_;
};

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Private: the layout of the eight-wide BVH.
//
// A node holds the boxes of its children as rows of eight floats, lower beside upper: one cache line for each
// axis, of which a ray reads one half as near and the other as far. A leaf is one block of up to four
// primitives. Boxes are those of padded() (accel/canonical/slab.h); there is none for the root.
#pragma once
#include <cstdint>
#include <vector>

#include "accel/build/big_vector.h"
#include "accel/build/binary_tree.h"
#include "accel/canonical/primitive_block.h"
#include "core/aabb.h"

namespace twinray {

/// What a child is: a block, an instance, an inner node, or nothing.
struct WideRef {
  static constexpr std::uint32_t block_bit = 1u << 31, no_child = 0xffffffff;
  /// Beside block_bit: to a tree without instances they would be blocks.
  static constexpr std::uint32_t instance_bit = 1u << 30;

  std::uint32_t bits = no_child;

  static WideRef block(std::size_t index) { return {std::uint32_t(index) | block_bit}; }
  static WideRef instance(std::size_t index) { return {std::uint32_t(index) | block_bit | instance_bit}; }
  static WideRef node(std::size_t index) { return {std::uint32_t(index)}; }
  bool is_none() const { return bits == no_child; }
  /// A block or an instance, or nothing.
  bool is_leaf() const { return (bits & block_bit) != 0; }
  /// Of a leaf.
  bool is_instance() const { return (bits & instance_bit) != 0; }
  std::uint32_t index() const { return bits & ~(block_bit | instance_bit); }
  friend bool operator==(const WideRef&, const WideRef&) = default;
};

/// The children of an inner node; those in use come first. The box of one that is not is empty, which every
/// ray misses.
struct alignas(64) WideNode {
  static constexpr int width = 8;

  float planes[3][2][width];  ///< [axis][lower, upper][child]
  WideRef children[width];

  WideNode() {
    for (int child = 0; child < width; ++child) set_box(child, {});
  }
  /// How many children there are.
  int count() const {
    int count = 0;
    while (count < width && !children[count].is_none()) ++count;
    return count;
  }
  Aabb box(int child) const {
    return {{planes[0][0][child], planes[1][0][child], planes[2][0][child]},
            {planes[0][1][child], planes[1][1][child], planes[2][1][child]}};
  }
  void set_box(int child, const Aabb& box) {
    for (int axis = 0; axis < 3; ++axis) {
      planes[axis][0][child] = box.lower[axis];
      planes[axis][1][child] = box.upper[axis];
    }
  }
};
static_assert(sizeof(WideNode) == 256, "four cache lines");

/// A tree that was built in parts has at most so many levels above them.
inline constexpr int max_part_depth = 24;
/// A wide node stands for at least one level of the binary tree it was made from, so no wide tree is deeper.
/// A traversal keeps at most seven siblings a level, and looks at eight before it goes on with one; a batch
/// has a mark below them.
inline constexpr int max_wide_depth = max_part_depth + max_bvh_depth;
inline constexpr int wide_stack_size = (WideNode::width - 1) * max_wide_depth + 2;
/// One level above both trees, that of the scene and that of a prototype.
inline constexpr int instanced_stack_size = 2 * wide_stack_size + WideNode::width;

/// Finished trees in one: that of the scene, whose leaves are blocks and instances, and those of the
/// prototypes. Where nothing can be hit there is no root.
struct WideBvh {
  using Node = WideNode;

  WideRef root;
  std::vector<WideRef> prototypes;  ///< Their roots; none where they are empty.
  BigVector<WideNode> nodes;        ///< Of each tree in depth-first order.
  BigVector<PrimitiveBlock> blocks;

  /// By how much the names of blocks grow that come behind these.
  std::size_t block_places() const { return blocks.size(); }
  const WideNode& node(WideRef ref) const { return nodes[ref.index()]; }
  const PrimitiveBlock& block(WideRef ref) const { return blocks[ref.index()]; }

  std::size_t bytes() const {
    return nodes.size() * sizeof(WideNode) + blocks.size() * sizeof(PrimitiveBlock);
  }
};

}  // namespace twinray

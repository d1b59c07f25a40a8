// SPDX-License-Identifier: Apache-2.0
// Private: the layout of the eight-wide BVH in little memory.
//
// A node's planes are those of a grid for each axis (accel/compact/grid.h), named by a byte each: 128 bytes
// where the ordinary node has 256. They are rounded outward, so a box contains what it contained before; by
// the canonical slab test (accel/canonical/slab.h) that is all that a tree must keep, and hits have the same
// bits. After Ylitie, Karras and Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide
// BVHs", High Performance Graphics 2017, whose grids begin at the node's corner and have steps of powers of
// two.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "accel/build/big_vector.h"
#include "accel/compact/grid.h"
#include "accel/compact/packed_block.h"
#include "accel/wide/node.h"

namespace twinray {

/// The children of an inner node; those in use come first.
struct alignas(64) CompactNode {
  WideRef children[WideNode::width];
  std::uint8_t planes[3][2][WideNode::width];  ///< [axis][lower, upper][child], as steps of the grid.
  Grid grids[3];
  std::uint32_t child_count;
  std::uint32_t unused[5] = {};  ///< Named, so that equal trees have equal bytes.

  /// Of a node whose boxes are finite.
  explicit CompactNode(const WideNode& node);

  int count() const { return int(child_count); }
  /// Of a child in use.
  Aabb box(int child) const {
    Aabb box;
    for (int axis = 0; axis < 3; ++axis) {
      box.lower[axis] = grids[axis].plane(planes[axis][0][child]);
      box.upper[axis] = grids[axis].plane(planes[axis][1][child]);
    }
    return box;
  }
};
static_assert(sizeof(CompactNode) == 128, "two cache lines");

/// Finished trees in one, as those of WideBvh, with packed blocks for leaves.
struct CompactBvh {
  using Node = CompactNode;

  WideRef root;
  std::vector<WideRef> prototypes;
  BigVector<CompactNode> nodes;
  /// Packed one behind the other, each from a multiple of packed_unit on; a block's index in WideRef counts
  /// these. Behind each tree's last one follow packed_slack words.
  BigVector<std::uint16_t> blocks;

  CompactBvh() = default;
  /// The same tree, its leaves packed; on as many threads as with_threads allows. Throws Error where the
  /// packed blocks are too many to be counted.
  explicit CompactBvh(const WideBvh& bvh);

  std::size_t block_places() const { return blocks.size() / packed_unit; }
  const CompactNode& node(WideRef ref) const { return nodes[ref.index()]; }
  const std::uint16_t* packed(WideRef ref) const { return blocks.data() + packed_unit * ref.index(); }
  PrimitiveBlock block(WideRef ref) const { return unpacked(packed(ref)); }
  std::size_t bytes() const {
    return nodes.size() * sizeof(CompactNode) + blocks.size() * sizeof(std::uint16_t);
  }
};

}  // namespace twinray

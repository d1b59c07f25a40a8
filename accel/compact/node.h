// SPDX-License-Identifier: Apache-2.0
// Private: the layout of the eight-wide BVH in little memory.
//
// A node's planes are multiples, of one byte each, of a power of two for each axis, counted from the lower
// corner of the node's box: 96 bytes where the ordinary node has 256. They are rounded outward, so a box
// contains what it contained before; by the canonical slab test (accel/canonical/slab.h) that is all that a
// tree must keep, and hits have the same bits. After Ylitie, Karras and Laine, "Efficient Incoherent Ray
// Traversal on GPUs Through Compressed Wide BVHs", High Performance Graphics 2017.
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "accel/build/big_vector.h"
#include "accel/compact/packed_block.h"
#include "accel/wide/node.h"

namespace twinray {

/// The children of an inner node; those in use come first.
struct alignas(32) CompactNode {
  WideRef children[WideNode::width];
  std::uint8_t planes[3][2][WideNode::width];  ///< [axis][lower, upper][child], as steps from the origin.
  float origin[3];
  /// The exponent of the step, as in a float's bits: 1 to 254.
  std::uint8_t exponents[3];
  std::uint8_t child_count;

  /// Of a node whose boxes are finite.
  explicit CompactNode(const WideNode& node);

  int count() const { return child_count; }
  float step(int axis) const { return std::bit_cast<float>(std::uint32_t(exponents[axis]) << 23); }
  /// A product that is exact, and a sum that is rounded: the larger the more steps.
  float plane(int axis, int steps) const { return float(steps) * step(axis) + origin[axis]; }
  /// Of a child in use.
  Aabb box(int child) const {
    Aabb box;
    for (int axis = 0; axis < 3; ++axis) {
      box.lower[axis] = plane(axis, planes[axis][0][child]);
      box.upper[axis] = plane(axis, planes[axis][1][child]);
    }
    return box;
  }
};
static_assert(sizeof(CompactNode) == 96, "a cache line and a half");

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

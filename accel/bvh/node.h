// SPDX-License-Identifier: Apache-2.0
// Private: the layout of the hand-written binary BVH.
//
// Siblings lie together in one cache line, their boxes as a structure of arrays, because a traversal always
// looks at both. The root's box stands apart. Boxes are those of padded() (accel/canonical/slab.h).
#pragma once
#include <cstdint>
#include <vector>

#include "accel/canonical/primitive_block.h"
#include "core/aabb.h"

namespace twinray {

/// What a node is: a leaf of `count` > 0 blocks from block `first` on, or, with a count of 0, an inner node
/// whose children are the pair `first`.
struct NodeRef {
  std::uint32_t first = 0, count = 0;
  bool is_leaf() const { return count > 0; }
  friend bool operator==(const NodeRef&, const NodeRef&) = default;
};

/// The two children of an inner node.
struct alignas(64) NodePair {
  float planes[3]
              [4];  ///< [axis]: lower of the first and the second child, upper of the first and the second.
  NodeRef children[2];

  static constexpr int count() { return 2; }
  Aabb box(int child) const {
    return {{planes[0][child], planes[1][child], planes[2][child]},
            {planes[0][2 + child], planes[1][2 + child], planes[2][2 + child]}};
  }
  void set_box(int child, const Aabb& box) {
    for (int axis = 0; axis < 3; ++axis) {
      planes[axis][child] = box.lower[axis];
      planes[axis][2 + child] = box.upper[axis];
    }
  }
  friend bool operator==(const NodePair&, const NodePair&) = default;
};
static_assert(sizeof(NodePair) == 64, "one cache line");

/// A finished tree. Without primitives the box is empty, and so are the arrays.
struct Bvh {
  Aabb box;
  NodeRef root;
  std::vector<NodePair> pairs;  ///< In depth-first order.
  std::vector<PrimitiveBlock>
      blocks;  ///< In the order of the leaves; only a leaf's last one may be part full.

  std::size_t bytes() const {
    return pairs.size() * sizeof(NodePair) + blocks.size() * sizeof(PrimitiveBlock);
  }
};

/// All trees of a geometry: one over the shapes that stand in the scene directly, one over the shapes of each
/// prototype, and one over the instances.
struct SceneBvh {
  Bvh direct;
  std::vector<Bvh> prototypes;
  Bvh instances;                              ///< Without blocks: leaf `first` is instance
  std::vector<std::uint32_t> instance_order;  ///< instance_order[first].

  std::size_t bytes() const {
    std::size_t sum = direct.bytes() + instances.bytes() + instance_order.size() * sizeof(std::uint32_t);
    for (const Bvh& prototype : prototypes) sum += prototype.bytes();
    return sum;
  }
};

}  // namespace twinray

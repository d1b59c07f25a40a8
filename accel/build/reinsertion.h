// SPDX-License-Identifier: Apache-2.0
// Private: makes a finished binary tree cheaper by moving subtrees to better places.
#pragma once
#include <cstdint>

#include "accel/build/binary_tree.h"

namespace twinray {

/// How long a tree is worked on, and how deep it may get.
struct ReinsertionEffort {
  int rounds = 0;
  /// Of all nodes, the part that a round tries to move: those with the largest areas. In (0, 1].
  double share = 1;
  int most_depth = max_bvh_depth;  ///< No leaf is moved below it; at most max_bvh_depth.
};

/// Moves subtrees where that lowers the sum of the inner nodes' areas, the part of the SAH cost that depends
/// on a tree's shape (Meister and Bittner, "Parallel Reinsertion for Bounding Volume Hierarchy Optimization",
/// Computer Graphics Forum 37(2), 2018). Leaves stay as they are. On as many threads
/// as with_threads allows; the same tree on any number of them. Pairs of children keep their places in the
/// array, but come to lie below other nodes. Returns how many nodes all searches for a better place looked
/// at.
std::uint64_t reinsert(BuildTree& tree, const ReinsertionEffort& effort);

}  // namespace twinray

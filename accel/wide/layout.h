// SPDX-License-Identifier: Apache-2.0
// Private: a binary tree laid out as an eight-wide one.
#pragma once
#include "accel/build/binary_tree.h"
#include "accel/wide/node.h"

namespace twinray {

/// Collapses a binary tree whose leaves hold at most max_leaf_size primitives, 1 to 4; on as many threads as
/// with_threads allows.
WideBvh widen(const BuildTree& tree, const Geometry& geometry, int max_leaf_size);

/// The nodes above other trees: of a binary tree with leaves of one each, whose `primitive` is such a tree's
/// number. In the leaf's place comes WideRef::instance of that number.
WideBvh widen_above(const BuildTree& tree);

}  // namespace twinray

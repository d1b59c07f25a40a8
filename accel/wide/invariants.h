// SPDX-License-Identifier: Apache-2.0
// Private: what is true of every finished eight-wide tree, for the tests.
#pragma once
#include <string>

#include "accel/build/coverage.h"
#include "accel/wide/node.h"
#include "core/geometry.h"

namespace twinray {

/// What is wrong with a tree over a geometry, in one sentence; empty where all holds: every primitive, with
/// the widening of padded(), lies in blocks as often as it should, every block and node has exactly one
/// parent (or is the root), nodes have two children at least and those come first, each box contains those of
/// its children, what is no child has an empty box, and no leaf is deeper than max_wide_depth. Of a compact
/// tree (Tree: CompactBvh) boxes contain the primitives below, but not always their children's boxes.
template <typename Tree>
std::string find_fault(const Tree& bvh, const Geometry& geometry, Occurrence occurrence = Occurrence::once);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Private: from a geometry to a finished eight-wide tree, by way of a binary one.
#pragma once
#include <vector>

#include "accel/accelerator.h"
#include "accel/build/binary_tree.h"
#include "accel/wide/node.h"

namespace twinray {

/// Collapses a binary tree whose leaves hold at most max_leaf_size primitives, 1 to 4; on as many threads as
/// with_threads allows.
WideBvh widen(const BuildTree& tree, const Geometry& geometry, int max_leaf_size);

/// All trees of a geometry. Builds on options.threads threads, the same trees on any number of them; adds how
/// long each step took to `phases`. Leaves hold four primitives at most, fewer if options.max_leaf_size says
/// so. Throws Error for more than 2^30 primitives, and where the builder is not part of this build.
WideBvh make_wide_bvh(const Geometry& geometry, const BuildOptions& options, std::vector<BuildPhase>& phases);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Private: from a geometry to its finished eight-wide trees.
#pragma once
#include <vector>

#include "accel/accelerator.h"
#include "accel/wide/node.h"

namespace twinray {

/// All trees of a geometry. Builds on options.threads threads, the same trees on any number of them; adds how
/// long each step took to `phases`. Leaves hold four primitives at most, fewer if options.max_leaf_size says
/// so. Throws Error for more than 2^30 primitives, and where the builder is not part of this build.
WideBvh make_wide_bvh(const Geometry& geometry, const BuildOptions& options, std::vector<BuildPhase>& phases);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Private: from a geometry to a finished binary tree.
#pragma once
#include <vector>

#include "accel/accelerator.h"
#include "accel/build/binary_tree.h"
#include "accel/bvh/node.h"

namespace twinray {

/// Lays a tree out for traversal: pads boxes, copies vertices into blocks.
Bvh lay_out(const BuildTree& tree, const Geometry& geometry);

/// Builds by the builder of the options on options.threads threads, and lays out; adds how long each step
/// took to `phases`. Throws Error where the builder is not part of this build. Of the shapes that stand in
/// the scene directly,
Bvh make_bvh(const Geometry& geometry, const BuildOptions& options, std::vector<BuildPhase>& phases);
/// and all trees.
SceneBvh make_scene_bvh(const Geometry& geometry, const BuildOptions& options,
                        std::vector<BuildPhase>& phases);

}  // namespace twinray

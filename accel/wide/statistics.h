// SPDX-License-Identifier: Apache-2.0
// Private: statistics of finished eight-wide trees.
#pragma once
#include "accel/accelerator.h"
#include "accel/wide/node.h"

namespace twinray {

/// The numbers of all trees of a scene, with the costs of the options. A node's traversal cost is counted
/// once, not for each of its children; an instance costs a step and what its prototype's tree does. Tree:
/// WideBvh or CompactBvh.
template <typename Tree>
TreeStats statistics_of(const Tree& bvh, const Geometry& geometry, const BuildOptions& options);

}  // namespace twinray

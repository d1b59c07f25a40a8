// SPDX-License-Identifier: Apache-2.0
// Private: statistics of finished binary trees.
#pragma once
#include "accel/accelerator.h"
#include "accel/bvh/node.h"

namespace twinray {

/// The numbers of all trees of a scene, with the costs of the options. An instance's leaf costs a step and
/// what its prototype's tree does.
TreeStats statistics_of(const SceneBvh& all, const Geometry& geometry, const BuildOptions& options);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Private: statistics of a finished binary tree.
#pragma once
#include "accel/accelerator.h"
#include "accel/bvh/node.h"

namespace twinray {

/// The numbers of a tree, with the costs of the options.
TreeStats statistics_of(const Bvh& bvh, const BuildOptions& options);

}  // namespace twinray

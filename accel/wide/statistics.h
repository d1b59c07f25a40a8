// SPDX-License-Identifier: Apache-2.0
// Private: statistics of a finished eight-wide tree.
#pragma once
#include "accel/accelerator.h"
#include "accel/wide/node.h"

namespace twinray {

/// The numbers of a tree, with the costs of the options. A node's traversal cost is counted once, not for
/// each of its children.
TreeStats statistics_of(const WideBvh& bvh, const BuildOptions& options);

}  // namespace twinray

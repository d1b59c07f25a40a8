// SPDX-License-Identifier: Apache-2.0
// Private: numbers about a finished eight-wide tree.
#pragma once
#include "accel/accelerator.h"
#include "accel/wide/node.h"

namespace twinray {

/// Fills in everything but the phases and the number of primitives. A node's traversal cost is counted once,
/// not for each of its children.
void add_statistics(const WideBvh& bvh, const BuildOptions& options, AccelStats& stats);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Private: numbers about a finished tree.
#pragma once
#include "accel/accelerator.h"
#include "accel/bvh/node.h"

namespace twinray {

/// Fills in everything but the phases and the number of primitives.
void add_statistics(const Bvh& bvh, const BuildOptions& options, AccelStats& stats);

}  // namespace twinray

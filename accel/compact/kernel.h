// SPDX-License-Identifier: Apache-2.0
// Private: the traversals of the compact tree, as accel/wide/kernel.h has those of the ordinary one.
#pragma once
#include <vector>

#include "accel/compact/node.h"
#include "accel/wide/kernel.h"

namespace twinray {

using CompactKernel = BasicWideKernel<CompactBvh>;
std::vector<CompactKernel> compact_kernels(WideTrees trees = WideTrees::plain);

using CountingCompactKernel = BasicWideKernel<CompactBvh, QueryCounts&>;
std::vector<CountingCompactKernel> counting_compact_kernels(WideTrees trees = WideTrees::plain);

}  // namespace twinray

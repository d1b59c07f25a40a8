// SPDX-License-Identifier: Apache-2.0
// Private: from a geometry to a finished compact tree.
#pragma once
#include <vector>

#include "accel/accelerator.h"
#include "accel/compact/node.h"

namespace twinray {

/// So many primitives, and fewer, are built in one part: a better tree, in 160 megabytes.
inline constexpr std::size_t least_part = std::size_t{1} << 20;

/// All trees of a geometry, as make_wide_bvh makes them, but in parts that are made compact one after the
/// other (accel/compact/partition.h); parts of fewer than `least` primitives are not divided.
CompactBvh make_compact_bvh(const Geometry& geometry, const BuildOptions& options,
                            std::vector<BuildPhase>& phases, std::size_t least = least_part);

}  // namespace twinray

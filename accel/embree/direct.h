// SPDX-License-Identifier: Apache-2.0
// Private: Embree's own functions with nothing of ours around them, for benchmarks that compare with Embree.
#pragma once
#include <cstddef>
#include <span>

#include "accel/accelerator.h"

namespace twinray::embree {

/// How many rays hit something, by rtcIntersect1 and rtcOccluded1 on the scene of an engine embree_native
/// (throws Error for another one). The rays are not checked: each must be valid. Spheres are ours, and their
/// callbacks want a checked ray: geometry with some is asked through the interface.
std::size_t closest_hits_directly(const Accelerator& native, std::span<const Ray> rays);
std::size_t any_hits_directly(const Accelerator& native, std::span<const Ray> rays);

}  // namespace twinray::embree

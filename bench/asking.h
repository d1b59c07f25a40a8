// SPDX-License-Identifier: Apache-2.0
// Asking an engine about many rays, in its own way: once to check its answers, then against the clock.
#pragma once
#include <span>
#include <vector>

#include "bench/engines.h"
#include "check/recorded_rays.h"

namespace twinray::bench {

/// The answers to rays of a kind, by the calls that shoot() makes; t = 0 stands for a shadow ray that is
/// blocked.
std::vector<Hit> answers_of(const Engine& engine, const Accelerator& accelerator, RayKind kind,
                            std::span<const Ray> rays);

/// What is timed: the same, and the answers are dropped.
void shoot(const Engine& engine, const Accelerator& accelerator, RayKind kind, std::span<const Ray> rays);

}  // namespace twinray::bench

// SPDX-License-Identifier: Apache-2.0
// Private: how long the phases of a build take.
#pragma once
#include <chrono>
#include <vector>

#include "accel/accelerator.h"

namespace twinray {

/// Runs `work` and adds its wall-clock time to `phases`, to the one of this name if there is one.
template <typename Work>
void timed(const char* name, std::vector<BuildPhase>& phases, Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  for (BuildPhase& phase : phases)
    if (phase.name == name) return void(phase.seconds += passed.count());
  phases.push_back({name, passed.count()});
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "bench/timing.h"
#include "bench/workload.h"

namespace twinray::bench {

/// How long a scene file takes to read, from its first byte to a checked scene.
struct ReadingStatistics {
  std::string scene;
  double megabytes = 0;  ///< 10^6 bytes.
  std::size_t primitives = 0;
  std::vector<double> seconds;  ///< CPU time, one number a round.
};

/// Of a scene that comes from a file. Throws Error where the file does not give the workload's scene again.
ReadingStatistics measure_reading(const Workload& workload, const Rounds& rounds);

}  // namespace twinray::bench

// SPDX-License-Identifier: Apache-2.0
// Building and single rays, all engines on one scene.
#pragma once
#include <functional>
#include <span>
#include <string>

#include "bench/statistics.h"
#include "bench/timing.h"

namespace twinray::bench {

struct TraceOptions {
  Rounds rounds;
  int most_build_rounds = 3;   ///< Fewer where building takes long.
  bool is_full = false;        ///< Engines of Wanted::full take part.
  std::string engine_pattern;  ///< Where set, a regular expression for the engines besides the baseline.
};

/// Measures the engines on a scene. As many at a time as memory allows are built, always with the baseline
/// beside them, checked, and traced by turns; so each ratio is of neighbours in time. `progress` is told what
/// is being done.
SceneStatistics measure_scene(Workload& workload, const TraceOptions& options,
                              const std::function<void(const std::string&)>& progress);

}  // namespace twinray::bench

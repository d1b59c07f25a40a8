// SPDX-License-Identifier: Apache-2.0
// What was measured: plain values, from which every report is made.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "bench/workload.h"

namespace twinray::bench {

/// The quartiles of some numbers, interpolated between them.
struct Quartiles {
  double low = 0, median = 0, high = 0;
};
/// Zeros where there are no numbers.
Quartiles quartiles(std::vector<double> values);

/// One engine and one ray set.
struct TraceStatistics {
  std::size_t rays = 0;             ///< 0: the scene's paths have none of this kind.
  std::vector<double> nanoseconds;  ///< CPU time of a ray, one a round.
  std::vector<double> speed;  ///< The baseline's time in the same round over this one's: above 1 is faster.
  /// Absent where the engine has none, or cannot count them.
  std::optional<double> nodes_per_ray, primitives_per_ray;
};

struct BuildStatistics {
  std::vector<double> wall_seconds, cpu_seconds;  ///< One a round, on all threads.
  AccelStats stats;
};

/// One engine on one scene.
struct EngineStatistics {
  std::string name;
  std::string complaint;  ///< Why it was not timed; empty if it was.
  BuildStatistics build;
  std::array<TraceStatistics, ray_sets.size()> trace;  ///< By ray_sets.

  /// One a round: the geometric means over the ray sets that the scene has.
  std::vector<double> mean_speed() const;
  std::vector<double> mean_nanoseconds() const;
};

struct SceneStatistics {
  std::string name, family;
  std::size_t primitives = 0;
  std::vector<EngineStatistics> engines;  ///< The baseline first.
};

}  // namespace twinray::bench

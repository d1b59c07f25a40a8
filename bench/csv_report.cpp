// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "bench/reports.h"

namespace twinray::bench {
namespace {

std::string spread(const std::vector<double>& values) {
  if (values.empty()) return ",,";
  const Quartiles q = quartiles(values);
  return fmt::format("{:.6g},{:.6g},{:.6g}", q.median, q.low, q.high);
}

std::string known(std::optional<double> value) { return value ? fmt::format("{:.6g}", *value) : ""; }

std::string row(const SceneStatistics& scene, const EngineStatistics& engine, const std::string& set,
                const std::string& rest) {
  return fmt::format("{},{},{},{},{},{:.6g},{}\n", scene.name, scene.primitives, engine.name, set, rest,
                     quartiles(engine.build.wall_seconds).median, engine.build.stats.bytes);
}

}  // namespace

std::string csv_report(const Results& results) {
  std::string text =
      "scene,primitives,engine,ray_set,rays,nanoseconds_median,nanoseconds_q1,nanoseconds_q3,speed_median,"
      "speed_q1,speed_q3,nodes_per_ray,primitives_per_ray,build_seconds,bytes\n";
  for (const SceneStatistics& scene : results.scenes)
    for (const EngineStatistics& engine : scene.engines) {
      if (!engine.complaint.empty()) continue;
      text += row(scene, engine, "all",
                  fmt::format(",{},{},,", spread(engine.mean_nanoseconds()), spread(engine.mean_speed())));
      for (std::size_t set = 0; set < ray_sets.size(); ++set) {
        const TraceStatistics& f = engine.trace[set];
        if (f.rays > 0)
          text += row(scene, engine, ray_sets[set].name,
                      fmt::format("{},{},{},{},{}", f.rays, spread(f.nanoseconds), spread(f.speed),
                                  known(f.nodes_per_ray), known(f.primitives_per_ray)));
      }
    }
  return text;
}

}  // namespace twinray::bench

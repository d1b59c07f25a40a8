// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "bench/reports.h"

namespace twinray::bench {
namespace {

using Json = nlohmann::ordered_json;

/// Every round's number, and what they come to.
Json spread(const std::vector<double>& values) {
  const Quartiles q = quartiles(values);
  return {{"median", q.median}, {"q1", q.low}, {"q3", q.high}, {"rounds", values}};
}

Json trace(const EngineFigures& engine) {
  Json sets;
  for (std::size_t set = 0; set < ray_sets.size(); ++set) {
    const TraceFigures& f = engine.trace[set];
    if (f.rays == 0) continue;
    sets[ray_sets[set].name] = {{"rays", f.rays},
                                {"nanoseconds", spread(f.nanoseconds)},
                                {"speed", spread(f.speed)},
                                {"nodes_per_ray", f.nodes_per_ray},
                                {"primitives_per_ray", f.primitives_per_ray}};
  }
  return sets;
}

Json to_json(const EngineFigures& engine) {
  Json json{{"name", engine.name}};
  if (!engine.complaint.empty()) json["complaint"] = engine.complaint;
  json["build"] = {{"seconds", spread(engine.build.wall_seconds)},
                   {"cpu_seconds", spread(engine.build.cpu_seconds)},
                   {"bytes", engine.build.stats.bytes},
                   {"nodes", engine.build.stats.nodes},
                   {"sah_cost", engine.build.stats.sah_cost}};
  json["speed"] = spread(engine.mean_speed());
  json["nanoseconds"] = spread(engine.mean_nanoseconds());
  json["rays"] = trace(engine);
  return json;
}

}  // namespace

std::string json_report(const Results& results) {
  Json json;
  for (const auto& [name, value] : results.machine) json["machine"][name] = value;
  json["rounds"] = results.rounds;
  json["recorded_picture"] = {{"width", results.width}, {"height", results.height}};
  json["scenes"] = Json::array();
  for (const SceneFigures& scene : results.scenes) {
    Json engines = Json::array();
    for (const EngineFigures& engine : scene.engines) engines.push_back(to_json(engine));
    json["scenes"].push_back({{"name", scene.name},
                              {"family", scene.family},
                              {"primitives", scene.primitives},
                              {"engines", engines}});
  }
  return json.dump(1) + "\n";
}

}  // namespace twinray::bench

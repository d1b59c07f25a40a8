// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "bench/reports.h"

namespace twinray::bench {
namespace {

using Json = nlohmann::ordered_json;

/// Every round's number, and what they come to.
Json spread_json(const std::vector<double>& values) {
  const Quartiles q = quartiles(values);
  return {{"median", q.median}, {"q1", q.low}, {"q3", q.high}, {"rounds", values}};
}

Json known_json(std::optional<double> value) { return value ? Json(*value) : Json(); }

Json trace(const EngineStatistics& engine) {
  Json sets;
  for (std::size_t set = 0; set < ray_sets.size(); ++set) {
    const TraceStatistics& f = engine.trace[set];
    if (f.rays == 0) continue;
    sets[ray_sets[set].name] = {{"rays", f.rays},
                                {"nanoseconds", spread_json(f.nanoseconds)},
                                {"speed", spread_json(f.speed)},
                                {"nodes_per_ray", known_json(f.nodes_per_ray)},
                                {"primitives_per_ray", known_json(f.primitives_per_ray)}};
  }
  return sets;
}

Json to_json(const EngineStatistics& engine) {
  Json json{{"name", engine.name}};
  if (!engine.complaint.empty()) json["complaint"] = engine.complaint;
  json["build"] = {{"seconds", spread_json(engine.build.wall_seconds)},
                   {"cpu_seconds", spread_json(engine.build.cpu_seconds)},
                   {"bytes", engine.build.stats.bytes},
                   {"nodes", nullptr},
                   {"sah_cost", nullptr}};
  if (const auto& tree = engine.build.stats.tree) {
    json["build"]["nodes"] = tree->nodes;
    json["build"]["sah_cost"] = tree->sah_cost;
  }
  json["speed"] = spread_json(engine.mean_speed());
  json["nanoseconds"] = spread_json(engine.mean_nanoseconds());
  json["rays"] = trace(engine);
  return json;
}

Json to_json(const PictureOfScene& picture) {
  Json json{{"scene", picture.scene}, {"samples", picture.samples}, {"engines", Json::array()}};
  for (const PictureStatistics& engine : picture.engines)
    json["engines"].push_back({{"name", engine.engine},
                               {"seconds", spread_json(engine.seconds)},
                               {"speed", spread_json(engine.speed)},
                               {"replay_seconds", spread_json(engine.replay_seconds)},
                               {"all_threads_seconds", spread_json(engine.wall_seconds)}});
  return json;
}

Json to_json(const ReadingStatistics& reading) {
  return {{"scene", reading.scene},
          {"megabytes", reading.megabytes},
          {"primitives", reading.primitives},
          {"seconds", spread_json(reading.seconds)}};
}

Json to_json(const ErrorStatistics& error) {
  Json json{{"scene", error.scene},
            {"engine", error.engine},
            {"reference_samples", error.reference_samples},
            {"points", Json::array()}};
  for (const ErrorPoint& point : error.points)
    json["points"].push_back({{"samples", point.samples},
                              {"seconds", spread_json(point.seconds)},
                              {"relative_error", point.error}});
  return json;
}

Json to_json(const ScalingStatistics& scaling) {
  Json json{{"scene", scaling.scene}, {"engine", scaling.engine}, {"points", Json::array()}};
  for (const ScalingPoint& point : scaling.points)
    json["points"].push_back({{"threads", point.threads},
                              {"samples_per_second", spread_json(point.rate)},
                              {"processes_samples_per_second", spread_json(point.processes_rate)}});
  return json;
}

template <class Statistics>
Json list(const std::vector<Statistics>& all) {
  Json json = Json::array();
  for (const Statistics& statistics : all) json.push_back(to_json(statistics));
  return json;
}

}  // namespace

std::string json_report(const Results& results) {
  Json json;
  for (const auto& [name, value] : results.machine) json["machine"][name] = value;
  json["rounds"] = results.rounds;
  json["recorded_picture"] = {{"width", results.width}, {"height", results.height}};
  json["scenes"] = Json::array();
  for (const SceneStatistics& scene : results.scenes) {
    Json engines = Json::array();
    for (const EngineStatistics& engine : scene.engines) engines.push_back(to_json(engine));
    json["scenes"].push_back({{"name", scene.name},
                              {"family", scene.family},
                              {"primitives", scene.primitives},
                              {"engines", engines}});
  }
  json["reading"] = list(results.readings);
  json["pictures"] = list(results.pictures);
  json["errors"] = list(results.errors);
  json["scaling"] = list(results.scalings);
  return json.dump(1) + "\n";
}

}  // namespace twinray::bench

// SPDX-License-Identifier: Apache-2.0
#include "cli/stats_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/version.h"
#include "core/parallel.h"

namespace twinray {
namespace {

double per_ray(std::uint64_t count, const RayFigures& rays) {
  return rays.rays == 0 ? 0 : double(count) / double(rays.rays);
}

/// A number where it is known, else `unknown`.
template <typename T>
std::string known(bool is_known, fmt::format_string<T&> format, T value, const char* unknown) {
  return is_known ? fmt::format(format, value) : unknown;
}

std::string row_text(const EngineFigures& engine, std::size_t widest) {
  const AccelStats& build = engine.build;
  const TreeStats tree = build.tree.value_or(TreeStats{});
  std::string text = fmt::format(
      "{:{}}  {:>9.4f}  {:>9}  {:>5}  {:>7}  {:>8.2f}", engine.name, widest, build.build_seconds(),
      known(engine.has_tree, "{}", tree.nodes, "-"), known(engine.has_tree, "{}", tree.depth, "-"),
      known(engine.has_tree, "{:.2f}", tree.sah_cost, "-"), 1e-6 * double(build.bytes));
  for (const RayFigures& rays : engine.rays)
    text += fmt::format(" | {:>6}  {:>6}  {:>6.3f}",
                        known(engine.has_tree, "{:.2f}", per_ray(rays.counts.nodes, rays), "-"),
                        known(engine.has_primitives, "{:.2f}", per_ray(rays.counts.primitives, rays), "-"),
                        1e-6 * rays.rays_per_second);
  return text + "\n";
}

std::string head_text(std::size_t widest) {
  std::string kinds = fmt::format("{:{}}", "", widest + 48);
  std::string names = fmt::format("{:{}}  {:>9}  {:>9}  {:>5}  {:>7}  {:>8}", "engine", widest, "build s",
                                  "nodes", "depth", "SAH", "MB");
  for (const RayKind kind : ray_kinds) {
    kinds += fmt::format(" | {:<22}", fmt::format("{} rays", ray_kind_name(kind)));
    names += fmt::format(" | {:>6}  {:>6}  {:>6}", "nodes", "prims", "M/s");
  }
  return kinds.substr(0, kinds.find_last_not_of(' ') + 1) + "\n" + names + "\n";
}

nlohmann::ordered_json counts_json(const EngineFigures& engine, const RayFigures& rays) {
  nlohmann::ordered_json json{{"rays", rays.rays}, {"rays_per_second", rays.rays_per_second}};
  const auto add = [&](const char* name, bool is_known, std::uint64_t count) {
    json[name] = is_known ? nlohmann::ordered_json(count) : nlohmann::ordered_json(nullptr);
    const std::string mean = fmt::format("{}_per_ray", name);
    json[mean] = is_known ? nlohmann::ordered_json(per_ray(count, rays)) : nlohmann::ordered_json(nullptr);
  };
  add("nodes", engine.has_tree, rays.counts.nodes);
  add("boxes", engine.has_tree, rays.counts.boxes);
  add("leaves", engine.has_primitives, rays.counts.leaves);
  add("primitives", engine.has_primitives, rays.counts.primitives);
  return json;
}

nlohmann::ordered_json engine_json(const EngineFigures& engine) {
  using nlohmann::ordered_json;
  const AccelStats& build = engine.build;
  const TreeStats tree = build.tree.value_or(TreeStats{});
  ordered_json json{{"name", engine.name}, {"build_seconds", build.build_seconds()}, {"bytes", build.bytes}};
  json["nodes"] = engine.has_tree ? ordered_json(tree.nodes) : ordered_json(nullptr);
  json["leaves"] = engine.has_tree ? ordered_json(tree.leaves) : ordered_json(nullptr);
  json["depth"] = engine.has_tree ? ordered_json(tree.depth) : ordered_json(nullptr);
  json["sah_cost"] = engine.has_tree ? ordered_json(tree.sah_cost) : ordered_json(nullptr);
  for (std::size_t kind = 0; kind < ray_kinds.size(); ++kind)
    json[ray_kind_name(ray_kinds[kind])] = counts_json(engine, engine.rays[kind]);
  return json;
}

int threads_used(const StatsArguments& arguments) {
  return arguments.options.threads > 0 ? arguments.options.threads : available_threads();
}

}  // namespace

std::string stats_text(const StatsArguments& arguments, const SceneFigures& figures) {
  std::size_t widest = 6;
  for (const EngineFigures& engine : figures.engines) widest = std::max(widest, engine.name.size());
  std::string text = head_text(widest);
  for (const EngineFigures& engine : figures.engines) text += row_text(engine, widest);
  const Recording& recording = arguments.options.recording;
  const EngineFigures& first = figures.engines.front();
  text += fmt::format(
      "{} primitives. Nodes and primitives a ray, million rays a second, {} thread{}; rays of paths of a "
      "picture\n"
      "of {} x {} pixels, {} sample{} each, view {}: {} camera, {} shadow, {} bounce.\n",
      first.build.primitives, threads_used(arguments), threads_used(arguments) == 1 ? "" : "s",
      recording.width, recording.height, recording.samples, recording.samples == 1 ? "" : "s",
      view_name(arguments.view), first.rays[0].rays, first.rays[1].rays, first.rays[2].rays);
  if (figures.is_brute_force_left_out)
    text += "Brute force is left out: it would take too long here; fewer pixels (-r) let it in.\n";
  return text;
}

std::string stats_csv(const SceneFigures& figures) {
  std::string text =
      "engine,primitives,build_seconds,nodes,leaves,depth,sah_cost,bytes,kind,rays,nodes_per_ray,"
      "boxes_per_ray,leaves_per_ray,primitives_per_ray,rays_per_second\n";
  for (const EngineFigures& engine : figures.engines)
    for (std::size_t kind = 0; kind < ray_kinds.size(); ++kind) {
      const AccelStats& build = engine.build;
      const TreeStats tree = build.tree.value_or(TreeStats{});
      const RayFigures& rays = engine.rays[kind];
      const bool has_tree = engine.has_tree, primitives = engine.has_primitives;
      text += fmt::format(
          "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", engine.name, build.primitives,
          build.build_seconds(), known(has_tree, "{}", tree.nodes, ""),
          known(has_tree, "{}", tree.leaves, ""), known(has_tree, "{}", tree.depth, ""),
          known(has_tree, "{}", tree.sah_cost, ""), build.bytes, ray_kind_name(ray_kinds[kind]), rays.rays,
          known(has_tree, "{}", per_ray(rays.counts.nodes, rays), ""),
          known(has_tree, "{}", per_ray(rays.counts.boxes, rays), ""),
          known(primitives, "{}", per_ray(rays.counts.leaves, rays), ""),
          known(primitives, "{}", per_ray(rays.counts.primitives, rays), ""), rays.rays_per_second);
    }
  return text;
}

std::string stats_json(const StatsArguments& arguments, const SceneFigures& figures) {
  const Recording& recording = arguments.options.recording;
  nlohmann::ordered_json json{{"program", version_name()},
                              {"scene", arguments.scene},
                              {"view", view_name(arguments.view)},
                              {"resolution", {recording.width, recording.height}},
                              {"samples_per_pixel", recording.samples},
                              {"threads", threads_used(arguments)},
                              {"primitives", figures.engines.front().build.primitives},
                              {"engines", nlohmann::ordered_json::array()}};
  for (const EngineFigures& engine : figures.engines) json["engines"].push_back(engine_json(engine));
  return json.dump(2) + "\n";
}

}  // namespace twinray

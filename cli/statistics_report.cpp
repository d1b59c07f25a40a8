// SPDX-License-Identifier: Apache-2.0
#include "cli/statistics_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/version.h"
#include "core/memory.h"
#include "core/parallel.h"
#include "io/picture/texture_store.h"

namespace twinray {
namespace {

using nlohmann::ordered_json;

/// A file's name may hold bytes that are no letters.
std::string text_of(const ordered_json& json) {
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

double mean(std::uint64_t count, std::uint64_t rays) { return rays == 0 ? 0 : double(count) / double(rays); }

double per_ray(std::uint64_t count, const RayStatistics& rays) { return mean(count, rays.rays); }

double rays_per_second(const RenderResult& result) {
  return result.seconds > 0 ? double(result.rays.total()) / result.seconds : 0;
}

/// The tree's numbers, of an engine that shows it.
std::string tree_text(const std::optional<TreeStats>& tree) {
  if (!tree) return "";
  return fmt::format("{} nodes, depth {}, SAH cost {:.2f}, ", tree->nodes, tree->depth, tree->sah_cost);
}

/// "Per ray        1.2 nodes, 2.4 boxes, 1 leaves, 3.1 intersection tests", as far as it is known.
std::string per_ray_text(const RenderArguments& arguments, const AccelStats& accel, const RayCounts& rays) {
  const QueryCounts& counts = rays.queries;
  const auto of = [&](std::uint64_t count) { return mean(count, rays.total()); };
  std::string text = "Per ray        ";
  if (accel.tree) text += fmt::format("{:.4f} nodes, {:.4f} boxes, ", of(counts.nodes), of(counts.boxes));
  text += fmt::format("{:.4f} leaves, {:.4f} intersection tests", of(counts.leaves), of(counts.primitives));
  if (counts.instances > 0) text += fmt::format(", {:.4f} instances", of(counts.instances));
  if (arguments.backend == Backend::embree) text += " (Embree's way: other machines may count otherwise)";
  return text + "\n";
}

double hit_rate(const TileStatistics& tiles) {
  return tiles.lookups == 0 ? 1 : 1 - double(tiles.tiles_read) / double(tiles.lookups);
}

/// "Textures       2 pictures of 1.2 GB: 340 tiles (16.7 MB) read, ...", where memory for them is bounded.
std::string texture_text(const RenderArguments& arguments) {
  if (!arguments.load.textures) return "";
  const TextureStatistics textures = arguments.load.textures->statistics();
  return fmt::format(
      "Textures       {} pictures of {}: {} tiles ({}) read, at most {} of {} in memory, {:.2f} % of {} "
      "texels "
      "found there\n",
      textures.pictures, bytes_text(textures.picture_bytes), textures.tiles.tiles_read,
      bytes_text(textures.bytes_read()), bytes_text(textures.tiles.peak_bytes),
      bytes_text(textures.most_bytes), 100 * hit_rate(textures.tiles), textures.tiles.lookups);
}

ordered_json texture_json(const RenderArguments& arguments) {
  if (!arguments.load.textures) return nullptr;
  const TextureStatistics textures = arguments.load.textures->statistics();
  return {{"pictures", textures.pictures},
          {"picture_bytes", textures.picture_bytes},
          {"limit_bytes", textures.most_bytes},
          {"peak_bytes", textures.tiles.peak_bytes},
          {"tiles_read", textures.tiles.tiles_read},
          {"bytes_read", textures.bytes_read()},
          {"lookups", textures.tiles.lookups},
          {"hit_rate", hit_rate(textures.tiles)},
          {"tiles_failed", textures.tiles.tiles_failed}};
}

/// A number where it is known, else null.
template <typename T>
ordered_json known_json(bool is_known, T value) {
  return is_known ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json build_json(const AccelStats& build) {
  ordered_json phases = ordered_json::array();
  for (const BuildPhase& phase : build.phases)
    phases.push_back({{"name", phase.name}, {"seconds", phase.seconds}});
  const bool has_tree = build.tree.has_value();
  const TreeStats tree = build.tree.value_or(TreeStats{});
  return {{"seconds", build.build_seconds()},
          {"phases", phases},
          {"primitives", build.primitives},
          {"nodes", known_json(has_tree, tree.nodes)},
          {"leaves", known_json(has_tree, tree.leaves)},
          {"depth", known_json(has_tree, tree.depth)},
          {"sah_cost", known_json(has_tree, tree.sah_cost)},
          {"bytes", build.bytes}};
}

/// What an engine counts.
struct Known {
  bool nodes = false, primitives = false;
};

/// Adds the counts of all rays and of one.
void add_counts(ordered_json& json, const QueryCounts& counts, std::uint64_t rays, const Known& known) {
  const auto add = [&](const char* name, bool is_known, std::uint64_t count) {
    json["counts"][name] = known_json(is_known, count);
    json["per_ray"][name] = known_json(is_known && rays > 0, mean(count, rays));
  };
  add("nodes", known.nodes, counts.nodes);
  add("boxes", known.nodes, counts.boxes);
  add("leaves", known.primitives, counts.leaves);
  add("primitives", known.primitives, counts.primitives);
  add("instances", known.primitives, counts.instances);
}

/// A number where it is known, else `unknown`.
template <typename T>
std::string known(bool is_known, fmt::format_string<T&> format, T value, const char* unknown) {
  return is_known ? fmt::format(format, value) : unknown;
}

std::string row_text(const EngineStatistics& engine, std::size_t widest) {
  const AccelStats& build = engine.build;
  const TreeStats tree = build.tree.value_or(TreeStats{});
  std::string text = fmt::format(
      "{:{}}  {:>9.4f}  {:>9}  {:>5}  {:>7}  {:>8.2f}", engine.name, widest, build.build_seconds(),
      known(engine.has_tree, "{}", tree.nodes, "-"), known(engine.has_tree, "{}", tree.depth, "-"),
      known(engine.has_tree, "{:.2f}", tree.sah_cost, "-"), 1e-6 * double(build.bytes));
  for (const RayStatistics& rays : engine.rays) {
    const bool are_any = rays.rays > 0;
    text += fmt::format(
        " | {:>6}  {:>6}  {:>6}",
        known(are_any && engine.has_tree, "{:.2f}", per_ray(rays.counts.nodes, rays), "-"),
        known(are_any && engine.has_primitives, "{:.2f}", per_ray(rays.counts.primitives, rays), "-"),
        known(are_any, "{:.3f}", 1e-6 * rays.rays_per_second, "-"));
  }
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

ordered_json engine_json(const EngineStatistics& engine) {
  ordered_json json{{"engine", engine.name}, {"build", build_json(engine.build)}};
  for (std::size_t kind = 0; kind < ray_kinds.size(); ++kind) {
    const RayStatistics& rays = engine.rays[kind];
    ordered_json& of_kind = json[ray_kind_name(ray_kinds[kind])];
    of_kind = {{"rays", rays.rays}, {"rays_per_second", known_json(rays.rays > 0, rays.rays_per_second)}};
    add_counts(of_kind, rays.counts, rays.rays, {engine.has_tree, engine.has_primitives});
  }
  return json;
}

/// What shows how the sample came about, or at least renders its pixel alone.
std::string remedy(const RejectedSample& at, int frame_height, const RenderArguments& arguments) {
  if (traces_paths(arguments.integrator))
    return fmt::format("--replay {} {} {} shows its path", at.x, at.y, at.index);
  if (is_cs184(arguments)) return fmt::format("-p {} {} 1 1 renders it alone", at.x, frame_height - 1 - at.y);
  return fmt::format("--crop {} {} 1 1 renders it alone", at.x, at.y);
}

ordered_json rejected_json(const Film& film) {
  if (film.rejected_count() == 0) return nullptr;
  const RejectedSample first = film.first_rejected();
  return {{"x", first.x}, {"y", first.y}, {"sample", first.index}};
}

int threads_used(const StatsArguments& arguments) {
  return arguments.options.threads > 0 ? arguments.options.threads : available_threads();
}

/// ", 37 samples per pixel" where time or noise decided how many, and ", relative error 0.05" where noise
/// might have.
std::string samples_text(const RenderOptions& render, const RenderResult& result) {
  std::string text = is_open_ended(render) ? fmt::format(", {} samples per pixel", render.samples) : "";
  if (result.error) text += fmt::format(", relative error {:.3g}", *result.error);
  return text;
}

ordered_json error_json(const RenderResult& result) {
  return result.error ? ordered_json(*result.error) : ordered_json(nullptr);
}

}  // namespace

std::string statistics_text(const RenderArguments& arguments, const AccelStats& accel,
                            const RenderResult& result) {
  const RayCounts& rays = result.rays;
  const std::string counts = arguments.render.counting ? per_ray_text(arguments, accel, rays) : "";
  const std::string text = fmt::format(
      "Engine         {}: {}\n"
      "Primitives     {}\n"
      "Build          {:.4f} s, {}{:.1f} MB\n"
      "Render         {:.4f} s{}\n"
      "Rays           {} ({} camera, {} shadow, {} bounce)\n"
      "Speed          {:.4f} million rays per second\n",
      engine_name(arguments), arguments.engine_reason, accel.primitives, accel.build_seconds(),
      tree_text(accel.tree), 1e-6 * double(accel.bytes), result.seconds,
      samples_text(arguments.render, result), rays.total(), rays.camera, rays.shadow, rays.bounce,
      1e-6 * rays_per_second(result));
  return text + counts + texture_text(arguments);
}

std::string statistics_json(const RenderArguments& arguments, const AccelStats& accel,
                            const RenderResult& result, const FurtherStatistics& further) {
  const RayCounts& rays = result.rays;
  ordered_json json{
      {"program", version_name()},
      {"scene", arguments.scene},
      {"engine", engine_name(arguments)},
      {"engine_reason", arguments.engine_reason},
      {"seed", arguments.render.seed},
      {"samples_per_pixel", arguments.render.samples},
      {"filter", filter_text(arguments.render.filter)},
      {"resolution", {arguments.render.width, arguments.render.height}},
      {"build", build_json(accel)},
      {"render",
       {{"seconds", result.seconds},
        {"estimated_error", error_json(result)},
        {"rejected_samples", result.film.rejected_count()},
        {"first_rejected", rejected_json(result.film)}}},
      {"rays",
       {{"camera", rays.camera}, {"shadow", rays.shadow}, {"bounce", rays.bounce}, {"total", rays.total()}}},
      {"rays_per_second", rays_per_second(result)}};
  if (arguments.render.counting)
    add_counts(json, rays.queries, rays.total(), {.nodes = accel.tree.has_value(), .primitives = true});
  json["textures"] = texture_json(arguments);
  if (further.denoised)
    json["denoising"] = {{"denoiser", further.denoised->denoiser}, {"seconds", further.denoised->seconds}};
  if (!further.check.empty()) json["check"] = ordered_json::parse(further.check);
  return text_of(json);
}

std::string unread_tiles_text(const RenderArguments& arguments) {
  if (!arguments.load.textures) return {};
  const TileStatistics tiles = arguments.load.textures->statistics().tiles;
  if (tiles.tiles_failed == 0) return {};
  return fmt::format("{} tiles of textures could not be read, and are magenta. The first: {}",
                     tiles.tiles_failed, tiles.first_failure);
}

std::string rejection_text(const Film& film, const RenderArguments& arguments) {
  if (film.rejected_count() == 0) return {};
  const RejectedSample first = film.first_rejected();
  return fmt::format(
      "{} samples were rejected: not finite or beyond {:g}. The first: pixel {} {}, sample {}; {}",
      film.rejected_count(), Film::max_value, first.x, first.y, first.index,
      remedy(first, film.frame_height(), arguments));
}

std::string stats_text(const StatsArguments& arguments, const SceneStatistics& statistics) {
  std::size_t widest = 6;
  for (const EngineStatistics& engine : statistics.engines) widest = std::max(widest, engine.name.size());
  std::string text = head_text(widest);
  for (const EngineStatistics& engine : statistics.engines) text += row_text(engine, widest);
  const Recording& recording = arguments.options.recording;
  const EngineStatistics& first = statistics.engines.front();
  text += fmt::format(
      "{} primitives. Nodes and primitives a ray, million rays a second, {} thread{}; rays of paths of a "
      "picture\n"
      "of {} x {} pixels, {} sample{} each, view {}: {} camera, {} shadow, {} bounce.\n",
      first.build.primitives, threads_used(arguments), threads_used(arguments) == 1 ? "" : "s",
      recording.width, recording.height, recording.samples, recording.samples == 1 ? "" : "s",
      view_name(arguments.view), first.rays[0].rays, first.rays[1].rays, first.rays[2].rays);
  if (std::any_of(statistics.engines.begin(), statistics.engines.end(),
                  [](const EngineStatistics& engine) { return engine.name == "embree"; }))
    text += "Other machines may count otherwise in embree; all other counts are the same everywhere.\n";
  if (statistics.is_brute_force_left_out)
    text += "Brute force is left out: it would take too long here; fewer pixels (-r) let it in.\n";
  return text;
}

std::string stats_csv(const SceneStatistics& statistics) {
  std::string text =
      "engine,primitives,build_seconds,nodes,leaves,depth,sah_cost,bytes,kind,rays,nodes_per_ray,"
      "boxes_per_ray,leaves_per_ray,primitives_per_ray,rays_per_second\n";
  for (const EngineStatistics& engine : statistics.engines)
    for (std::size_t kind = 0; kind < ray_kinds.size(); ++kind) {
      const AccelStats& build = engine.build;
      const TreeStats tree = build.tree.value_or(TreeStats{});
      const RayStatistics& rays = engine.rays[kind];
      const bool has_tree = engine.has_tree, are_any = rays.rays > 0;
      const bool nodes = are_any && has_tree, primitives = are_any && engine.has_primitives;
      text +=
          fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", engine.name, build.primitives,
                      build.build_seconds(), known(has_tree, "{}", tree.nodes, ""),
                      known(has_tree, "{}", tree.leaves, ""), known(has_tree, "{}", tree.depth, ""),
                      known(has_tree, "{}", tree.sah_cost, ""), build.bytes, ray_kind_name(ray_kinds[kind]),
                      rays.rays, known(nodes, "{}", per_ray(rays.counts.nodes, rays), ""),
                      known(nodes, "{}", per_ray(rays.counts.boxes, rays), ""),
                      known(primitives, "{}", per_ray(rays.counts.leaves, rays), ""),
                      known(primitives, "{}", per_ray(rays.counts.primitives, rays), ""),
                      known(are_any, "{}", rays.rays_per_second, ""));
    }
  return text;
}

std::string stats_json(const StatsArguments& arguments, const SceneStatistics& statistics) {
  const Recording& recording = arguments.options.recording;
  ordered_json json{{"program", version_name()},
                    {"scene", arguments.scene},
                    {"view", view_name(arguments.view)},
                    {"resolution", {recording.width, recording.height}},
                    {"samples_per_pixel", recording.samples},
                    {"threads", threads_used(arguments)},
                    {"primitives", statistics.engines.front().build.primitives},
                    {"engines", ordered_json::array()}};
  for (const EngineStatistics& engine : statistics.engines) json["engines"].push_back(engine_json(engine));
  return text_of(json);
}

}  // namespace twinray

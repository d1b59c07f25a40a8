// SPDX-License-Identifier: Apache-2.0
#include "cli/report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/version.h"

namespace twinray {
namespace {

double per_ray(std::uint64_t count, const RayCounts& rays) {
  return rays.total() == 0 ? 0 : double(count) / double(rays.total());
}

double rays_per_second(const RenderResult& result) {
  return result.seconds > 0 ? double(result.rays.total()) / result.seconds : 0;
}

/// The tree's numbers, of an engine that shows it.
std::string tree_text(const std::optional<TreeStats>& tree) {
  if (!tree) return "";
  return fmt::format("{} nodes, depth {}, SAH cost {:.2f}, ", tree->nodes, tree->depth, tree->sah_cost);
}

template <typename T>
nlohmann::ordered_json known(const std::optional<TreeStats>& tree, T TreeStats::*member) {
  return tree ? nlohmann::ordered_json(*tree.*member) : nlohmann::ordered_json(nullptr);
}

}  // namespace

std::string figures_text(const AccelStats& accel, const RenderResult& result, bool counted) {
  const RayCounts& rays = result.rays;
  std::string text = fmt::format(
      "Primitives     {}\n"
      "Build          {:.4f} s, {}{:.1f} MB\n"
      "Render         {:.4f} s\n"
      "Rays           {} ({} camera, {} shadow, {} bounce)\n"
      "Speed          {:.4f} million rays per second\n",
      accel.primitives, accel.build_seconds(), tree_text(accel.tree), 1e-6 * double(accel.bytes),
      result.seconds, rays.total(), rays.camera, rays.shadow, rays.bounce, 1e-6 * rays_per_second(result));
  if (counted)
    text +=
        fmt::format("Per ray        {:.4f} nodes, {:.4f} boxes, {:.4f} leaves, {:.4f} intersection tests\n",
                    per_ray(rays.queries.nodes, rays), per_ray(rays.queries.boxes, rays),
                    per_ray(rays.queries.leaves, rays), per_ray(rays.queries.primitives, rays));
  return text;
}

std::string figures_json(const RenderArguments& arguments, const AccelStats& accel,
                         const RenderResult& result, const std::string& check) {
  using nlohmann::ordered_json;
  ordered_json phases = ordered_json::array();
  for (const BuildPhase& phase : accel.phases)
    phases.push_back({{"name", phase.name}, {"seconds", phase.seconds}});
  const RayCounts& rays = result.rays;
  ordered_json json{
      {"program", version_name()},
      {"scene", arguments.scene},
      {"engine", backend_name(arguments.backend)},
      {"seed", arguments.render.seed},
      {"samples_per_pixel", arguments.render.samples},
      {"resolution", {arguments.render.width, arguments.render.height}},
      {"build",
       {{"seconds", accel.build_seconds()},
        {"phases", phases},
        {"primitives", accel.primitives},
        {"nodes", known(accel.tree, &TreeStats::nodes)},
        {"leaves", known(accel.tree, &TreeStats::leaves)},
        {"depth", known(accel.tree, &TreeStats::depth)},
        {"sah_cost", known(accel.tree, &TreeStats::sah_cost)},
        {"bytes", accel.bytes}}},
      {"render", {{"seconds", result.seconds}, {"rejected_samples", result.film.rejected_count()}}},
      {"rays",
       {{"camera", rays.camera}, {"shadow", rays.shadow}, {"bounce", rays.bounce}, {"total", rays.total()}}},
      {"rays_per_second", rays_per_second(result)}};
  if (arguments.render.counting) {
    const QueryCounts& q = rays.queries;
    json["counts"] = {
        {"nodes", q.nodes}, {"boxes", q.boxes}, {"leaves", q.leaves}, {"primitives", q.primitives}};
    json["per_ray"] = {{"nodes", per_ray(q.nodes, rays)},
                       {"boxes", per_ray(q.boxes, rays)},
                       {"leaves", per_ray(q.leaves, rays)},
                       {"primitives", per_ray(q.primitives, rays)}};
  }
  if (!check.empty()) json["check"] = ordered_json::parse(check);
  return json.dump(2) + "\n";
}

std::string rejection_text(const Film& film) {
  if (film.rejected_count() == 0) return {};
  const RejectedSample first = film.first_rejected();
  return fmt::format(
      "{} samples were rejected: not finite or beyond {:g}. The first: pixel {} {}, sample {}; render it "
      "alone with "
      "--crop {} {} 1 1",
      film.rejected_count(), Film::max_value, first.x, first.y, first.index, first.x, first.y);
}

}  // namespace twinray

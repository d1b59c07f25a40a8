// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "bench/html_plots.h"
#include "bench/reports.h"
#include "io/html/page.h"

namespace twinray::bench {
namespace {

std::string engine_table() {
  std::vector<std::pair<std::string, std::string>> rows;
  for (const Engine& engine : engines()) rows.emplace_back(engine.name, engine.what);
  return "<h3>The engines</h3>\n" + html::facts(rows);
}

/// "1.234 [1.200, 1.260]", the quartiles small.
std::string spread(const std::vector<double>& values, const char* format) {
  if (values.empty()) return "–";
  const Quartiles q = quartiles(values);
  const auto show = [format](double value) { return fmt::format(fmt::runtime(format), value); };
  return fmt::format("{} <small>[{}, {}]</small>", show(q.median), show(q.low), show(q.high));
}

std::string bytes_per_primitive(const SceneStatistics& scene, const EngineStatistics& engine) {
  return fmt::format("{:.1f}",
                     double(engine.build.stats.bytes) / double(std::max<std::size_t>(1, scene.primitives)));
}

std::string headline_row(const SceneStatistics& scene, const EngineStatistics& engine) {
  const bool is_baseline = &engine == &scene.engines.front();
  std::vector<std::string> cells{is_baseline ? html::escaped(scene.name) : "",
                                 is_baseline ? fmt::format("{}", scene.primitives) : "", engine.name};
  if (!engine.complaint.empty()) {
    cells.push_back(fmt::format("<span class=\"bad\">{}</span>", html::escaped(engine.complaint)));
  } else {
    cells.push_back(fmt::format("<b>{}</b>", spread(engine.mean_speed(), "{:.3f}")));
    for (const TraceStatistics& statistics : engine.trace)
      cells.push_back(spread(statistics.speed, "{:.3f}"));
    cells.push_back(fmt::format("{:.3f} s", quartiles(engine.build.wall_seconds).median));
    cells.push_back(bytes_per_primitive(scene, engine));
  }
  return html::row(cells, is_baseline ? "base" : "");
}

std::string headline_table(const Results& results) {
  std::vector<std::string> heads{"scene", "primitives", "engine", "speed"};
  for (const RaySetKind& set : ray_sets) heads.push_back(set.title);
  heads.insert(heads.end(), {"build", "bytes per primitive"});
  std::string rows;
  for (const SceneStatistics& scene : results.scenes)
    for (const EngineStatistics& engine : scene.engines) rows += headline_row(scene, engine);
  return html::table(heads, rows);
}

std::string rate_row(const EngineStatistics& engine) {
  const auto known = [](std::optional<double> count) { return count ? fmt::format("{:.2f}", *count) : "–"; };
  std::vector<std::string> cells{engine.name};
  for (const TraceStatistics& statistics : engine.trace) {
    std::vector<double> rates;
    for (const double nanoseconds : statistics.nanoseconds) rates.push_back(1e3 / nanoseconds);
    cells.insert(cells.end(), {spread(rates, "{:.3g}"), known(statistics.nodes_per_ray),
                               known(statistics.primitives_per_ray)});
  }
  return html::row(cells);
}

/// Million rays per second, nodes and primitive tests, by scene.
std::string rate_table(const SceneStatistics& scene) {
  std::vector<std::string> heads{"engine"};
  for (const RaySetKind& set : ray_sets)
    heads.insert(heads.end(), {fmt::format("{}<br>M rays/s", set.title), "nodes", "tests"});
  std::string rows;
  for (const EngineStatistics& engine : scene.engines)
    if (engine.complaint.empty()) rows += rate_row(engine);
  return fmt::format("<h3>{} <small>({} primitives)</small></h3>\n{}", html::escaped(scene.name),
                     scene.primitives, html::table(heads, rows));
}

}  // namespace

std::string html_report(const Results& results) {
  const std::string baseline = results.scenes.empty() ? "" : results.scenes.front().engines.front().name;
  std::string body = fmt::format(
      "<p>Single rays on one thread, recorded once for each scene from the program's own paths (a picture of "
      "{} × {} "
      "pixels) and traced in the picture's order by every engine, whose answers were checked before. A "
      "speed is "
      "the CPU time of <b>{}</b> over the engine's in the same round: above 1 is faster. Medians of {} "
      "rounds in which "
      "the engines take turns, in brackets and as thin lines the quartiles.</p>\n",
      results.width, results.height, html::escaped(baseline), results.rounds);
  body += html::facts(results.machine) + engine_table();
  body += "<h2>Speed by scene</h2>\n" + speed_plots(results);
  body += "<h2>The same in numbers</h2>\n" + headline_table(results);
  if (const std::string growth = growth_plots(results); !growth.empty())
    body += "<h2>Growth with the number of triangles</h2>\n" + growth;
  body += "<h2>Build time against speed</h2>\n" + build_plot(results);
  body += whole_section(results);
  body += reading_section(results);
  body +=
      "<h2>Rays per second, nodes and primitive tests</h2>\n<p>Nodes and primitive tests are counted by a "
      "traversal of "
      "its own, which is not timed; a dash stands for what an engine cannot count.</p>\n";
  for (const SceneStatistics& scene : results.scenes) body += rate_table(scene);
  return html::page("twinray: benchmarks", body);
}

}  // namespace twinray::bench

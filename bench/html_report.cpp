// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "bench/html_plots.h"
#include "bench/reports.h"
#include "bench/svg.h"

namespace twinray::bench {
namespace {

constexpr const char* style = R"(
:root { color-scheme: light; }
body { font: 15px/1.5 system-ui, "Segoe UI", Roboto, "Noto Sans", sans-serif; color: #1c1c1e;
  background: #fafaf8; max-width: 76rem; margin: 2.5rem auto; padding: 0 1.5rem; }
h1 { font-size: 1.7rem; margin: 0 0 .3rem; } h2 { font-size: 1.25rem; margin: 2.6rem 0 .6rem; }
h3 { font-size: 1.02rem; margin: 1.8rem 0 .4rem; } p { max-width: 52rem; }
table { border-collapse: collapse; font-size: 13px; font-variant-numeric: tabular-nums; }
th, td { padding: .22rem .6rem; text-align: right; white-space: nowrap; }
th { font-weight: 600; border-bottom: 1.5px solid #888; } td { border-bottom: 1px solid #e4e4df; }
th:first-child, td:first-child { text-align: left; } td small { color: #777; }
tr.base td { background: #f0f0ea; } .scroll { overflow-x: auto; }
.facts td { text-align: left; white-space: normal; }
.facts td:first-child { color: #666; white-space: nowrap; }
figure { margin: .6rem 0; background: #fff; border: 1px solid #e4e4df; border-radius: 6px; padding: .7rem; }
figure.wide { max-width: 56rem; } figcaption { font-weight: 600; margin-bottom: .2rem; }
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(27rem, 1fr)); gap: .8rem; }
svg { width: 100%; height: auto; display: block; } svg text { font-size: 11.5px; fill: #333; }
.plots svg text { font-size: 12.5px; } line.grid { stroke: #e8e8e4; }
line.one { stroke: #333; stroke-dasharray: 4 3; }
.legend { margin: .2rem 0 .4rem; font-size: 13px; max-width: none; } .legend span { margin-right: 1.1rem;
  white-space: nowrap; } .legend i { display: inline-block; width: .75rem; height: .75rem; border-radius: 50%;
  margin-right: .35rem; vertical-align: -1px; } .bad { color: #b00020; font-weight: 600; }
)";

std::string machine_table(const Results& results) {
  std::string html = "<table class=\"facts\">\n";
  for (const auto& [name, value] : results.machine)
    html += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", escaped(name), escaped(value));
  return html + "</table>\n";
}

std::string engine_table() {
  std::string html = "<h3>The engines</h3>\n<table class=\"facts\">\n";
  for (const Engine& engine : engines())
    html += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", engine.name, escaped(engine.what));
  return html + "</table>\n";
}

/// "1.234 [1.200, 1.260]", the quartiles small.
std::string spread(const std::vector<double>& values, const char* format) {
  if (values.empty()) return "–";
  const Quartiles q = quartiles(values);
  const auto show = [format](double value) { return fmt::format(fmt::runtime(format), value); };
  return fmt::format("{} <small>[{}, {}]</small>", show(q.median), show(q.low), show(q.high));
}

std::string headline_table(const Results& results) {
  std::string html =
      "<div class=\"scroll\"><table>\n<tr><th>scene</th><th>primitives</th><th>engine</th><th>speed</th>";
  for (const RaySetKind& set : ray_sets) html += fmt::format("<th>{}</th>", set.title);
  html += "<th>build</th><th>bytes per primitive</th></tr>\n";
  for (const SceneStatistics& scene : results.scenes)
    for (const EngineStatistics& engine : scene.engines) {
      const bool is_baseline = &engine == &scene.engines.front();
      html += fmt::format("<tr{}><td>{}</td><td>{}</td><td>{}</td>", is_baseline ? " class=\"base\"" : "",
                          is_baseline ? escaped(scene.name) : "",
                          is_baseline ? fmt::format("{}", scene.primitives) : "", engine.name);
      if (!engine.complaint.empty()) {
        html += fmt::format("<td class=\"bad\" colspan=\"8\">{}</td></tr>\n", escaped(engine.complaint));
        continue;
      }
      html += fmt::format("<td><b>{}</b></td>", spread(engine.mean_speed(), "{:.3f}"));
      for (const TraceStatistics& statistics : engine.trace)
        html += fmt::format("<td>{}</td>", spread(statistics.speed, "{:.3f}"));
      html +=
          fmt::format("<td>{:.3f} s</td><td>{:.1f}</td></tr>\n", quartiles(engine.build.wall_seconds).median,
                      double(engine.build.stats.bytes) / double(std::max<std::size_t>(1, scene.primitives)));
    }
  return html + "</table></div>\n";
}

/// Million rays per second, nodes and primitive tests, by scene.
std::string rate_table(const SceneStatistics& scene) {
  std::string html = fmt::format(
      "<h3>{} <small>({} primitives)</small></h3>\n<div class=\"scroll\"><table>\n<tr><th>engine</th>",
      escaped(scene.name), scene.primitives);
  for (const RaySetKind& set : ray_sets)
    html += fmt::format("<th>{}<br>M rays/s</th><th>nodes</th><th>tests</th>", set.title);
  html += "</tr>\n";
  for (const EngineStatistics& engine : scene.engines) {
    if (!engine.complaint.empty()) continue;
    html += fmt::format("<tr><td>{}</td>", engine.name);
    for (const TraceStatistics& statistics : engine.trace) {
      std::vector<double> rates;
      for (const double nanoseconds : statistics.nanoseconds) rates.push_back(1e3 / nanoseconds);
      const auto known = [](std::optional<double> count) {
        return count ? fmt::format("{:.2f}", *count) : "–";
      };
      html += fmt::format("<td>{}</td><td>{}</td><td>{}</td>", spread(rates, "{:.3g}"),
                          known(statistics.nodes_per_ray), known(statistics.primitives_per_ray));
    }
    html += "</tr>\n";
  }
  return html + "</table></div>\n";
}

}  // namespace

std::string html_report(const Results& results) {
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>twinray: benchmarks</title>\n<style>";
  html += style;
  html += "</style></head>\n<body>\n<h1>twinray: benchmarks</h1>\n";
  const std::string baseline = results.scenes.empty() ? "" : results.scenes.front().engines.front().name;
  html += fmt::format(
      "<p>Single rays on one thread, recorded once for each scene from the program's own paths (a picture of "
      "{} × {} "
      "pixels) and traced in the picture's order by every engine, whose answers were checked before. A "
      "speed is "
      "the CPU time of <b>{}</b> over the engine's in the same round: above 1 is faster. Medians of {} "
      "rounds in which "
      "the engines take turns, in brackets and as thin lines the quartiles.</p>\n",
      results.width, results.height, escaped(baseline), results.rounds);
  html += machine_table(results) + engine_table();
  html += "<h2>Speed by scene</h2>\n" + speed_plots(results);
  html += "<h2>The same in numbers</h2>\n" + headline_table(results);
  if (const std::string growth = growth_plots(results); !growth.empty())
    html += "<h2>Growth with the number of triangles</h2>\n" + growth;
  html += "<h2>Build time against speed</h2>\n" + build_plot(results);
  html += whole_section(results);
  html +=
      "<h2>Rays per second, nodes and primitive tests</h2>\n<p>Nodes and primitive tests are counted by a "
      "traversal of "
      "its own, which is not timed; a dash stands for what an engine cannot count.</p>\n";
  for (const SceneStatistics& scene : results.scenes) html += rate_table(scene);
  return html + "</body>\n</html>\n";
}

}  // namespace twinray::bench

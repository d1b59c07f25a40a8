// SPDX-License-Identifier: Apache-2.0
#include "bench/html_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "io/html/page.h"
#include "io/html/plot.h"

namespace twinray::bench {
namespace {

using html::color_of;
using html::Curves;
using html::Dots;
using html::draw;
using html::draw_bars;
using html::draw_legend;
using html::escaped;
using html::Mark;
using html::Series;

/// Below, building takes no time that could be compared.
constexpr std::size_t least_built = 1000;

/// Names of the engines that were timed, in the order of the table; brute force would hide all else.
std::vector<std::string> plotted_engines(const Results& results) {
  std::vector<std::string> names;
  for (const SceneStatistics& scene : results.scenes)
    for (const EngineStatistics& engine : scene.engines)
      if (engine.name != "brute-force" && std::find(names.begin(), names.end(), engine.name) == names.end())
        names.push_back(engine.name);
  return names;
}

const EngineStatistics* find_engine(const SceneStatistics& scene, const std::string& name) {
  for (const EngineStatistics& engine : scene.engines)
    if (engine.name == name && engine.complaint.empty()) return &engine;
  return nullptr;
}

/// A series for each engine; `mark` gives a scene's mark, or none: `Mark` or nothing.
template <class MakeMark>
std::vector<Series> series_of(const Results& results, const std::vector<const SceneStatistics*>& scenes,
                              const MakeMark& make_mark) {
  std::vector<Series> all;
  const std::vector<std::string> names = plotted_engines(results);
  for (std::size_t i = 0; i < names.size(); ++i) {
    Series series{names[i], color_of(i), {}};
    for (std::size_t row = 0; row < scenes.size(); ++row)
      if (const EngineStatistics* engine = find_engine(*scenes[row], names[i]))
        make_mark(*scenes[row], *engine, double(row), series.marks);
    all.push_back(std::move(series));
  }
  return all;
}

std::vector<const SceneStatistics*> all_scenes(const Results& results) {
  std::vector<const SceneStatistics*> all;
  for (const SceneStatistics& scene : results.scenes) all.push_back(&scene);
  return all;
}

Mark speed_mark(const SceneStatistics& scene, const EngineStatistics& engine,
                const std::vector<double>& speed, double row) {
  const Quartiles q = quartiles(speed);
  return {q.median, row, q.low, q.high,
          fmt::format("{} on {}: {:.3f} [{:.3f}, {:.3f}]", engine.name, scene.name, q.median, q.low, q.high)};
}

std::vector<std::string> names_of(const std::vector<const SceneStatistics*>& scenes) {
  std::vector<std::string> names;
  for (const SceneStatistics* scene : scenes) names.push_back(scene->name);
  return names;
}

/// The scenes of each family of which at least two sizes were measured, small ones first.
std::map<std::string, std::vector<const SceneStatistics*>> families(const Results& results) {
  std::map<std::string, std::vector<const SceneStatistics*>> all;
  for (const SceneStatistics& scene : results.scenes)
    if (!scene.family.empty()) all[scene.family].push_back(&scene);
  std::erase_if(all, [](const auto& family) { return family.second.size() < 2; });
  for (auto& [name, scenes] : all)
    std::sort(scenes.begin(), scenes.end(), [](auto* a, auto* b) { return a->primitives < b->primitives; });
  return all;
}

}  // namespace

std::string speed_plots(const Results& results) {
  const auto scenes = all_scenes(results);
  Dots all{"speed against the baseline, geometric mean over the ray sets", names_of(scenes), {}};
  all.series = series_of(results, scenes, [](const auto& scene, const auto& engine, double row, auto& marks) {
    const std::vector<double> speed = engine.mean_speed();
    if (!speed.empty()) marks.push_back(speed_mark(scene, engine, speed, row));
  });
  std::string html = draw_legend(all.series) + "<figure class=\"wide\">" + draw_bars(all) + "</figure>\n";
  html += "<h3>By ray set</h3>\n" + draw_legend(all.series) + "<div class=\"plots\">\n";
  for (std::size_t set = 0; set < ray_sets.size(); ++set) {
    Dots dots{fmt::format("speed against the baseline, {} rays", ray_sets[set].title), names_of(scenes), {}};
    dots.series =
        series_of(results, scenes, [set](const auto& scene, const auto& engine, double row, auto& marks) {
          if (!engine.trace[set].speed.empty())
            marks.push_back(speed_mark(scene, engine, engine.trace[set].speed, row));
        });
    html +=
        fmt::format("<figure><figcaption>{} rays</figcaption>{}</figure>\n", ray_sets[set].title, draw(dots));
  }
  return html + "</div>\n";
}

std::string growth_plots(const Results& results) {
  std::string html;
  for (const auto& [family, scenes] : families(results)) {
    Curves curves{.x_label = "triangles", .y_label = "nanoseconds per ray, mean of the ray sets"};
    curves.series =
        series_of(results, scenes, [](const auto& scene, const auto& engine, double, auto& marks) {
          const Quartiles q = quartiles(engine.mean_nanoseconds());
          if (q.median > 0)
            marks.push_back(
                {double(scene.primitives), q.median, q.low, q.high,
                 fmt::format("{}, {} triangles: {:.0f} ns", engine.name, scene.primitives, q.median)});
        });
    html += fmt::format("<figure class=\"wide\"><figcaption>{}</figcaption>{}{}</figure>\n", escaped(family),
                        draw_legend(curves.series), draw(curves));
  }
  return html;
}

std::string build_plot(const Results& results) {
  Curves curves{.x_label = "build time against the baseline's (right: slower to build)",
                .y_label = "speed against the baseline (up: faster)",
                .is_joined = false,
                .reference_y = 1,
                .reference_x = 1};
  curves.series =
      series_of(results, all_scenes(results), [](const auto& scene, const auto& engine, double, auto& marks) {
        const double build = quartiles(engine.build.wall_seconds).median;
        const double baseline = quartiles(scene.engines.front().build.wall_seconds).median;
        const Quartiles q = quartiles(engine.mean_speed());
        if (scene.primitives >= least_built && build > 0 && baseline > 0 && q.median > 0)
          marks.push_back({build / baseline, q.median, q.low, q.high,
                           fmt::format("{} on {}: build {:.2f} times as long, {:.3f} times as fast",
                                       engine.name, scene.name, build / baseline, q.median)});
      });
  return "<figure class=\"wide\">" + draw_legend(curves.series) + draw(curves) + "</figure>\n";
}

}  // namespace twinray::bench

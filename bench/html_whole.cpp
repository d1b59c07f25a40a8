// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "bench/html_plots.h"
#include "io/html/page.h"
#include "io/html/plot.h"

namespace twinray::bench {
namespace {

using html::color_of;
using html::Curves;
using html::draw;
using html::draw_legend;
using html::escaped;
using html::Series;

std::string cell(const std::vector<double>& values) {
  const Quartiles q = quartiles(values);
  return fmt::format("{:.3f} <small>[{:.3f}, {:.3f}]</small>", q.median, q.low, q.high);
}

std::vector<double> quotients(double numerator, const std::vector<double>& denominators) {
  std::vector<double> all;
  for (const double denominator : denominators) all.push_back(numerator / denominator);
  return all;
}

std::string picture_row(const PictureOfScene& picture, const PictureStatistics& engine) {
  const bool is_first = &engine == &picture.engines.front();
  const double share = quartiles(engine.replay_seconds).median / quartiles(engine.seconds).median;
  return html::row({is_first ? escaped(picture.scene) : "", engine.engine, cell(engine.speed),
                    cell(engine.seconds), cell(quotients(1e-6 * picture.samples, engine.seconds)),
                    cell(engine.replay_seconds), fmt::format("{:.0f} %", 100 * share),
                    cell(engine.wall_seconds), cell(quotients(1e-6 * picture.samples, engine.wall_seconds))},
                   is_first ? "base" : "");
}

std::string picture_table(const Results& results) {
  std::string rows;
  for (const PictureOfScene& picture : results.pictures)
    for (const PictureStatistics& engine : picture.engines) rows += picture_row(picture, engine);
  return html::table({"scene", "engine", "speed", "seconds", "M samples/s", "rays alone, s", "share",
                      "all threads, s", "M samples/s"},
                     rows);
}

/// The colours of the engines that render, told apart by their order.
std::string render_color(std::size_t index) { return color_of(index == 0 ? 0 : 3 + index); }

std::string error_plot(const Results& results) {
  Curves curves{.x_label = "CPU seconds of all threads",
                .y_label = "root mean square error over mean luminance"};
  for (std::size_t i = 0; i < results.errors.size(); ++i) {
    const ErrorStatistics& statistics = results.errors[i];
    Series series{statistics.engine, render_color(i), {}};
    for (const ErrorPoint& point : statistics.points) {
      const double seconds = quartiles(point.seconds).median;
      series.marks.push_back({seconds, point.error, 0, 0,
                              fmt::format("{}, {} samples per pixel: {:.3f} s, {:.4f}", statistics.engine,
                                          point.samples, seconds, point.error)});
    }
    curves.series.push_back(std::move(series));
  }
  return fmt::format(
      "<h3>Error over time</h3>\n<p>{}: the samples of a pixel double from point to point. The truth is a "
      "picture of {} samples from another seed. Equal pictures have equal errors: only the time "
      "differs.</p>\n"
      "<figure class=\"wide\">{}{}</figure>\n",
      escaped(results.errors.front().scene), results.errors.front().reference_samples,
      draw_legend(curves.series), draw(curves));
}

/// Two series: threads of one process, and as many processes.
void add_scaling(const ScalingStatistics& statistics, std::size_t index, std::vector<Series>& all) {
  Series threads{statistics.engine + ", threads", render_color(index), {}};
  Series processes{statistics.engine + ", processes", color_of(7 + index), {}};
  for (const ScalingPoint& point : statistics.points)
    for (Series* series : {&threads, &processes}) {
      const Quartiles q = quartiles(series == &threads ? point.rate : point.processes_rate);
      series->marks.push_back(
          {double(point.threads), 1e-6 * q.median, 1e-6 * q.low, 1e-6 * q.high,
           fmt::format("{} of {}: {:.3f} M samples/s", point.threads, series->name, 1e-6 * q.median)});
    }
  all.push_back(std::move(threads));
  all.push_back(std::move(processes));
}

std::string scaling_plots(const Results& results) {
  std::string html =
      "<h3>Threads</h3>\n<p>Samples per second of one picture on some threads, and of as many processes of "
      "one thread each, which share nothing but the machine.</p>\n<div class=\"plots\">\n";
  for (std::size_t begin = 0; begin < results.scalings.size();) {
    const std::string& scene = results.scalings[begin].scene;
    Curves curves{
        .x_label = "threads, or processes", .y_label = "million samples per second", .has_whole_x = true};
    std::size_t end = begin;
    for (; end < results.scalings.size() && results.scalings[end].scene == scene; ++end)
      add_scaling(results.scalings[end], end - begin, curves.series);
    html += fmt::format("<figure><figcaption>{}</figcaption>{}{}</figure>\n", escaped(scene),
                        draw_legend(curves.series), draw(curves));
    begin = end;
  }
  return html + "</div>\n";
}

}  // namespace

std::string whole_section(const Results& results) {
  if (results.pictures.empty()) return "";
  std::string html =
      "<h2>Whole pictures</h2>\n<p>Path-traced with up to five bounces, one sample a pixel, CPU time of one "
      "thread; then wall clock on all threads. Rays alone: the same rays in the same order without the "
      "renderer, and their share of the picture's time.</p>\n";
  html += picture_table(results);
  if (!results.errors.empty()) html += error_plot(results);
  if (!results.scalings.empty()) html += scaling_plots(results);
  return html;
}

}  // namespace twinray::bench

// SPDX-License-Identifier: Apache-2.0
// Tables of a study: what is compared with what.
#include <fmt/format.h>

#include "cli/study/page.h"
#include "io/html/page.h"
#include "io/html/plot.h"

namespace twinray::study {
namespace {

constexpr const char* unknown = "–";
constexpr const char* command_head = "<span class=\"command\">command</span>";

std::string ratio_text(double value, double base) {
  if (!(base > 0)) return unknown;
  return value / base < 100 ? fmt::format("{:.2f} ×", value / base) : fmt::format("{:.0f} ×", value / base);
}

/// The first result of the same group before this one, or this one.
const Result& leader_of(const std::vector<Result>& results, const Result& result) {
  for (const Result& other : results)
    if (other.figure->group == result.figure->group) return other;
  return result;
}

/// Calls add(result, record, leader's record) for every result that is made, in order.
template <class Add>
void for_each_made(const std::vector<Result>& results, const Add& add) {
  for (const Result& result : results) {
    const Result& leader = leader_of(results, result);
    if (result.record && leader.record) add(result, leader);
  }
}

bool is_leader(const Result& result, const Result& leader) { return &result == &leader; }

/// "1.23 s (0.87 ×)": a number of the result, with its ratio to the leader's unless it is that.
template <class Show, class Value>
std::string compared(const Result& result, const Result& leader, const Show& show, const Value& value) {
  const std::string text = show(value(*result.record));
  if (is_leader(result, leader)) return text;
  return fmt::format("{} <small>({})</small>", text,
                     ratio_text(value(*result.record), value(*leader.record)));
}

double build_seconds(const Record& record) { return record.build_seconds; }
double render_seconds(const Record& record) { return record.render_seconds; }
double tests(const Record& record) { return record.tests_per_ray; }

std::string group_cell(const Result& result, const Result& leader) {
  return is_leader(result, leader) ? html::escaped(result.figure->group) : "";
}

std::string hierarchy_table(const std::vector<Result>& results) {
  std::string rows;
  for_each_made(results, [&](const Result& result, const Result& leader) {
    const Record &record = *result.record, &base = *leader.record;
    const double seconds = record.build_seconds + record.render_seconds;
    const bool is_first = is_leader(result, leader);
    rows += html::row(
        {group_cell(result, leader), is_first ? fmt::format("{}", result.figure->picture.primitives) : "",
         html::escaped(result.figure->label), seconds_text(record.build_seconds),
         seconds_text(record.render_seconds),
         is_first ? unknown : ratio_text(base.build_seconds + base.render_seconds, seconds),
         tests_text(record.tests_per_ray), count_text(rays_per_second(record)), command_html(record.command)},
        is_first ? "base" : "");
  });
  return html::table({"scene", "primitives", "hierarchy", "build", "render", "faster by", "tests per ray",
                      "rays per second", command_head},
                     rows);
}

std::string splits_table(const std::vector<Result>& results) {
  std::string rows;
  for_each_made(results, [&](const Result& result, const Result& leader) {
    rows += html::row(
        {group_cell(result, leader), html::escaped(result.figure->label),
         compared(result, leader, seconds_text, build_seconds),
         compared(result, leader, seconds_text, render_seconds), compared(result, leader, tests_text, tests),
         compared(result, leader, count_text, rays_per_second), command_html(result.record->command)},
        is_leader(result, leader) ? "base" : "");
  });
  return html::table({"scene", "split", "build", "render", "tests per ray", "rays per second", command_head},
                     rows);
}

std::string errors_table(const std::vector<Result>& results) {
  std::string rows;
  for_each_made(results, [&](const Result& result, const Result& leader) {
    const Record& record = *result.record;
    rows += html::row(
        {group_cell(result, leader), html::escaped(result.figure->label), seconds_text(record.render_seconds),
         count_text(double(record.rays)), count_text(rays_per_second(record)),
         tests_text(record.tests_per_ray), error_text(result.error)},
        is_leader(result, leader) ? "base" : "");
  });
  return html::table({"scene", "picture", "render", "rays", "rays per second", "tests per ray", "error"},
                     rows);
}

/// "12.3 %" of samples that were not taken, next to those of the leader.
std::string saved_text(const Record& record, const Record& base) {
  return fmt::format("{:.1f} %", 100 * (1 - double(record.camera_rays) / double(base.camera_rays)));
}

std::string adaptive_table(const std::vector<Result>& results) {
  std::string rows;
  for_each_made(results, [&](const Result& result, const Result& leader) {
    if (!result.figure->converged) return;  // It is that itself.
    const Record &record = *result.record, &base = *leader.record;
    const double samples = double(result.figure->picture.samples) * double(record.camera_rays) /
                           double(std::max<std::uint64_t>(1, base.camera_rays));
    const bool is_whole = result.error && leader.error;
    rows += html::row(
        {group_cell(result, leader), html::escaped(result.figure->label), fmt::format("{:.1f}", samples),
         saved_text(record, base), compared(result, leader, seconds_text, render_seconds),
         error_text(result.error),
         is_whole ? fmt::format("{:+.2f} %", 100 * (result.error->relative - leader.error->relative))
                  : unknown,
         is_whole ? fmt::format("{:+.2f} %", 100 * result.error->brightness) : unknown},
        is_leader(result, leader) ? "base" : "");
  });
  return html::table(
      {"scene", "sampling", "samples per pixel", "saved", "render", "error", "error it cost", "brightness"},
      rows);
}

}  // namespace

std::string comparison_table(const Section& section, const std::vector<Result>& results) {
  switch (section.comparison) {
    case Comparison::hierarchy:
      return hierarchy_table(results);
    case Comparison::splits:
      return splits_table(results);
    case Comparison::errors:
      return errors_table(results);
    case Comparison::adaptive:
      return adaptive_table(results);
    default:
      return "";
  }
}

std::string error_plot(const Section& section, const std::vector<Result>& results) {
  html::Curves curves{.x_label = section.x_label, .y_label = "error"};
  for (const Result& result : results) {
    const Figure& figure = *result.figure;
    if (!result.error || !(result.error->relative > 0) || !(figure.x > 0)) continue;
    if (curves.series.empty() || curves.series.back().name != figure.group)
      curves.series.push_back({figure.group, html::color_of(3 + 2 * curves.series.size()), {}});
    const double error = result.error->relative;
    curves.series.back().marks.push_back(
        {figure.x, error, 0, 0,
         fmt::format("{}, {}: {}", figure.group, figure.label, error_text(result.error))});
  }
  if (section.x_label.empty() || curves.series.empty()) return "";
  return fmt::format("<figure class=\"wide\">{}{}</figure>\n", html::draw_legend(curves.series),
                     html::draw(curves));
}

std::string command_html(const std::string& command) {
  return fmt::format("<code class=\"command\">{}</code>", html::whole_words(command));
}

std::string seconds_text(double seconds) {
  if (seconds >= 10) return fmt::format("{:.1f} s", seconds);
  if (seconds < 1e-3) return fmt::format("{:.0f} µs", 1e6 * seconds);
  return seconds >= 0.1 ? fmt::format("{:.2f} s", seconds) : fmt::format("{:.1f} ms", 1000 * seconds);
}

std::string count_text(double count) {
  if (count >= 1e9) return fmt::format("{:.2f} G", 1e-9 * count);
  if (count >= 1e6) return fmt::format("{:.2f} M", 1e-6 * count);
  return count >= 1e4 ? fmt::format("{:.1f} k", 1e-3 * count) : fmt::format("{:.0f}", count);
}

std::string tests_text(double tests) {
  return tests < 100 ? fmt::format("{:.2f}", tests) : fmt::format("{:.0f}", tests);
}

std::string error_text(const std::optional<ImageError>& error) {
  return error ? fmt::format("{:.3g} %", 100 * error->relative) : unknown;
}

}  // namespace twinray::study

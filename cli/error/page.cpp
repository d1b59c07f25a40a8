// SPDX-License-Identifier: Apache-2.0
#include "cli/error/page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/error/tile_map.h"
#include "cli/version.h"
#include "io/html/page.h"
#include "io/html/plot.h"
#include "io/machine.h"

namespace twinray::error {
namespace {

std::string facts(const Heading& heading, const Summary& summary, const std::string& command) {
  std::vector<std::pair<std::string, std::string>> rows{{"command", command},
                                                        {"scene", heading.scene},
                                                        {"pictures", pixels_text(heading, summary)},
                                                        {"reference", reference_text(heading, summary)},
                                                        {"program", version_name()}};
  for (const CurveSummary& curve : summary.curves)
    if (!curve.options.empty())
      rows.emplace_back(curve.name, fmt::format("{}", fmt::join(curve.options, " ")));
  for (auto& fact : describe_machine()) rows.push_back(std::move(fact));
  return html::facts(rows);
}

std::string mse_cell(const Row& row) {
  return row.seeds < 2 ? fmt::format("{:.3g}", row.mse)
                       : fmt::format("{:.3g} <small>± {:.2g}</small>", row.mse, row.mse_standard_error);
}

std::string row_html(const CurveSummary& curve, const Row& row, const Summary& summary) {
  const bool is_first = &row == &curve.rows.front();
  const std::string p = html::escaped(p_value_cell(row));
  return html::row(
      {is_first ? html::escaped(curve.name) : "", samples_cell(row), seconds_cell(row.cpu_seconds),
       mse_cell(row), fmt::format("{:.3g}", rmse(row)), fmt::format("{:.3g}", row.relative_mse),
       bias_cell(row), is_biased(row, summary) ? fmt::format("<span class=\"bad\">{}</span>", p) : p},
      is_first ? "base" : "");
}

std::string error_table(const Summary& summary) {
  std::string rows;
  for (const CurveSummary& curve : summary.curves)
    for (const Row& row : curve.rows) rows += row_html(curve, row, summary);
  return html::table({"settings", "samples", "CPU seconds", "MSE", "RMSE", "relative MSE", "bias", "p"},
                     rows);
}

std::string target_table(const Summary& summary) {
  std::vector<std::string> heads{"settings"};
  for (const Target& target : summary.curves.front().targets) {
    heads.push_back(fmt::format("CPU seconds to RMSE {:g}", target.rmse));
    heads.push_back("samples");
  }
  std::string rows;
  for (const CurveSummary& curve : summary.curves) {
    std::vector<std::string> cells{html::escaped(curve.name)};
    for (const Target& target : curve.targets) {
      cells.push_back(target_cell(target.cpu_seconds));
      cells.push_back(target_cell(target.samples));
    }
    rows += html::row(cells);
  }
  return html::table(heads, rows);
}

/// What a plot shows: where each row stands.
struct Axes {
  std::string caption, x_label, y_label;
  double (*x)(const Row&);
  double (*y)(const Row&);
  double reference_y = 0;
};

std::string plot(const Summary& summary, const Axes& axes) {
  html::Curves curves{.x_label = axes.x_label, .y_label = axes.y_label, .series = {}};
  for (std::size_t i = 0; i < summary.curves.size(); ++i) {
    html::Series series{summary.curves[i].name, html::color_of(3 + i), {}};
    for (const Row& row : summary.curves[i].rows) {
      if (!(row.mse > 0) || !(axes.x(row) > 0)) continue;
      const double y = axes.y(row), part = row.mse_standard_error / row.mse;
      series.marks.push_back({axes.x(row), y, y * (1 - part), y * (1 + part),
                              fmt::format("{}: {} samples, {} s, {:.3g}", series.name, samples_cell(row),
                                          seconds_cell(row.cpu_seconds), row.mse)});
    }
    if (!series.marks.empty()) curves.series.push_back(std::move(series));
  }
  if (curves.series.empty()) return "";
  curves.reference_y = axes.reference_y;
  return fmt::format("<figure><figcaption>{}</figcaption>{}{}</figure>\n", axes.caption,
                     html::draw_legend(curves.series), html::draw(curves));
}

double samples(const Row& row) { return row.samples_per_pixel; }
double seconds(const Row& row) { return row.cpu_seconds; }
double mse(const Row& row) { return row.mse; }
double mse_seconds(const Row& row) { return row.mse * row.cpu_seconds; }

std::string plots(const Summary& summary) {
  const std::vector<Target>& targets = summary.curves.front().targets;
  const double target = targets.empty() ? 0 : targets.front().rmse * targets.front().rmse;
  const std::string error = "mean squared error", pixel = "samples per pixel", cpu = "CPU seconds";
  return "<div class=\"plots\">" + plot(summary, {"Error over samples", pixel, error, samples, mse, target}) +
         plot(summary, {"Error over CPU seconds", cpu, error, seconds, mse, target}) +
         plot(summary, {"Error times CPU seconds: lower is better", pixel, error + " x CPU seconds", samples,
                        mse_seconds}) +
         "</div>\n";
}

/// "= 0.34", "<1e-300"
std::string compared(const std::string& p_value) {
  return p_value.starts_with('<') ? p_value : "= " + p_value;
}

/// Of each set, with its largest number of samples.
std::string maps(const Summary& summary) {
  std::string figures;
  for (const CurveSummary& curve : summary.curves)
    if (!curve.rows.empty() && curve.rows.back().bias)
      figures += fmt::format("<figure><figcaption>{}, {} samples: p {}</figcaption>{}</figure>\n",
                             html::escaped(curve.name), curve.rows.back().samples,
                             html::escaped(compared(p_value_cell(curve.rows.back()))),
                             tile_map(*curve.rows.back().bias));
  if (figures.empty()) return "";
  return "<h2>Where pictures differ from the reference</h2>\n"
         "<p>Tiles of 16 x 16 pixels, by Welch's test: red is brighter than the reference, blue darker; the "
         "fuller the colour, the less likely by noise alone. Without bias a map is mottled and pale; a frame "
         "marks tiles that differ at a level of 1 % for all tiles together.</p>\n<div class=\"pictures\">" +
         figures + "</div>\n";
}

constexpr const char* columns = R"(<p>Errors are of linear radiance, over pixels, channels and seeds;
± is one standard error of the mean over the seeds. The relative error divides each squared difference by
the reference's square plus 0.01. Bias is the mean signed difference in luminance, as a part of the
reference's mean, with its standard error. p is the chance that noise alone makes the picture, or one of its
tiles, differ that much (Welch's test, corrected for the number of tiles). CPU seconds are the median over the
seeds, of all threads, without loading the scene and building its tree. ~ marks what lies beyond the measured
points.</p>
)";
}  // namespace

std::string error_page(const Heading& heading, const Summary& summary, const std::string& command) {
  std::string body = facts(heading, summary, command) + "<h2>Error</h2>\n" + error_table(summary) + columns;
  if (!summary.curves.front().targets.empty()) body += target_table(summary);
  for (const std::string& verdict : verdicts(summary)) body += "<p>" + html::escaped(verdict) + "</p>\n";
  if (const std::string warning = reference_warning(summary); !warning.empty())
    body += "<p class=\"missing\">" + html::escaped(warning) + "</p>\n";
  return html::page("Error of " + heading.scene, body + plots(summary) + maps(summary));
}

}  // namespace twinray::error

// SPDX-License-Identifier: Apache-2.0
#include "cli/error/tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace twinray::error {
namespace {

constexpr const char* unknown = "-";
/// Beyond this part of the smallest error the reference's own noise is worth a warning.
constexpr double noisy_part = 0.1;

/// "A: biased at 4, 16 samples", with what may explain it.
std::string verdict_of(const CurveSummary& curve, const Summary& summary) {
  std::vector<std::uint32_t> samples;
  for (const Row& row : curve.rows)
    if (is_biased(row, summary)) samples.push_back(row.samples);
  if (samples.empty()) return "";
  std::string text = fmt::format("{}: biased, or another picture than the reference, at {} samples.",
                                 curve.name, fmt::join(samples, ", "));
  if (samples.front() == 1) text += " A single sample goes through the pixel's centre: edges differ by that.";
  return text;
}

std::size_t widest_name(const Summary& summary) {
  std::size_t widest = 8;
  for (const CurveSummary& curve : summary.curves) widest = std::max(widest, curve.name.size());
  return widest;
}

std::string spread_cell(const Row& row) {
  if (row.seeds < 2 || !(row.mse > 0)) return unknown;
  return fmt::format("{:.1f} %", 100 * row.mse_standard_error / row.mse);
}

std::string text_row(const std::string& name, const Row& row, std::size_t name_width) {
  return fmt::format("{:<{}}  {:>8}  {:>9}  {:>9.3g}  {:>7}  {:>8.3g}  {:>9.3g}  {:>18}  {:>8}\n", name,
                     name_width, samples_cell(row), seconds_cell(row.cpu_seconds), row.mse, spread_cell(row),
                     rmse(row), row.relative_mse, bias_cell(row), p_value_cell(row));
}

std::string target_lines(const Summary& summary, std::size_t name_width) {
  std::string text;
  for (std::size_t i = 0; i < summary.curves.front().targets.size(); ++i) {
    text += fmt::format("\n{:<{}}  {:>16}  {:>16}\n",
                        fmt::format("to RMSE {:g}", summary.curves[0].targets[i].rmse), name_width,
                        "CPU seconds", "samples");
    for (const CurveSummary& curve : summary.curves)
      text += fmt::format("{:<{}}  {:>16}  {:>16}\n", curve.name, name_width,
                          target_cell(curve.targets[i].cpu_seconds), target_cell(curve.targets[i].samples));
  }
  return text;
}

/// A name as a field of CSV (RFC 4180).
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == text.npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string csv_bias(const Row& row) {
  if (!row.bias) return ",,,,";
  const TileTest& whole = row.bias->whole;
  return fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{}", whole.picture.mean - whole.converged.mean,
                     std::sqrt(whole.picture.variance + whole.converged.variance), whole.converged.mean,
                     row.bias->p_value, row.bias->tiles.size());
}

std::string csv_row(const Row& row, const CurveSummary& curve) {
  std::string text = fmt::format("{},{},{:.9g},{},{:.9g},{:.9g},{:.9g},{:.9g},{}", quoted(curve.name),
                                 row.samples, row.samples_per_pixel, row.seeds, row.cpu_seconds, row.mse,
                                 row.mse_standard_error, row.relative_mse, csv_bias(row));
  for (const Target& target : curve.targets) {
    text += target.cpu_seconds ? fmt::format(",{:.9g},{}", target.cpu_seconds->cost,
                                             int(target.cpu_seconds->is_extrapolated))
                               : ",,";
    text += target.samples ? fmt::format(",{:.9g}", target.samples->cost) : ",";
  }
  return text + "\n";
}

}  // namespace

std::string pixels_text(const Heading& heading, const Summary& summary) {
  return fmt::format("{} x {} pixels{}", heading.width, heading.height,
                     heading.leaves_out_emitters ? fmt::format(", without {} that see an emitter",
                                                               summary.pixels - summary.counted_pixels)
                                                 : "");
}

std::string reference_text(const Heading& heading, const Summary& summary) {
  return heading.reference +
         (summary.is_noise_known
              ? fmt::format("; its own mean squared error, {:.3g}, is subtracted", summary.own_error.mse)
              : "; its own noise is not known, and part of every error");
}

std::string reference_warning(const Summary& summary) {
  if (!summary.is_noise_known)
    return "the reference's noise is not known: it is part of every error, and counts as bias";
  double least = std::numeric_limits<double>::infinity();
  for (const CurveSummary& curve : summary.curves)
    for (const Row& row : curve.rows) least = std::min(least, row.mse);
  if (summary.own_error.mse == 0 || least > summary.own_error.mse / noisy_part) return "";
  return fmt::format(
      "the reference's own mean squared error, {:.3g}, is more than {:.0f} % of the least one measured: what "
      "is left of that is uncertain; --reference-samples takes more",
      summary.own_error.mse, 100 * noisy_part);
}

std::vector<std::string> verdicts(const Summary& summary) {
  std::vector<std::string> all;
  for (const CurveSummary& curve : summary.curves)
    if (const std::string verdict = verdict_of(curve, summary); !verdict.empty()) all.push_back(verdict);
  if (all.empty() && summary.tests() > 0)
    all.push_back(
        fmt::format("No bias found in {} tests, at a level of 1 % for all together.", summary.tests()));
  return all;
}

std::string samples_cell(const Row& row) {
  return row.samples_per_pixel == double(row.samples) ? fmt::format("{}", row.samples)
                                                      : fmt::format("{:.1f}", row.samples_per_pixel);
}

std::string seconds_cell(double seconds) {
  return seconds >= 100 ? fmt::format("{:.0f}", seconds) : fmt::format("{:.3g}", seconds);
}

std::string bias_cell(const Row& row) {
  if (!row.bias || !(row.bias->whole.converged.mean > 0)) return unknown;
  const TileTest& whole = row.bias->whole;
  const double percent = 100 / whole.converged.mean;
  return fmt::format("{:+.3f} ± {:.3f} %", percent * (whole.picture.mean - whole.converged.mean),
                     percent * std::sqrt(whole.picture.variance + whole.converged.variance));
}

std::string p_value_cell(const Row& row) {
  if (!row.bias) return unknown;
  if (row.bias->p_value < 1e-300) return "<1e-300";
  return row.bias->p_value >= 0.01 ? fmt::format("{:.2f}", row.bias->p_value)
                                   : fmt::format("{:.1g}", row.bias->p_value);
}

std::string target_cell(const std::optional<CostToError>& cost) {
  if (!cost) return unknown;
  return fmt::format("{}{}", cost->is_extrapolated ? "~" : "", seconds_cell(cost->cost));
}

std::string text_table(const Heading& heading, const Summary& summary) {
  const std::size_t width = widest_name(summary);
  std::string text = fmt::format("{}, {}\nReference: {}\n\n", heading.scene, pixels_text(heading, summary),
                                 reference_text(heading, summary));
  text += fmt::format("{:<{}}  {:>8}  {:>9}  {:>9}  {:>7}  {:>8}  {:>9}  {:>18}  {:>8}\n", "settings", width,
                      "samples", "CPU s", "MSE", "±", "RMSE", "rel. MSE", "bias", "p");
  for (const CurveSummary& curve : summary.curves)
    for (const Row& row : curve.rows) text += text_row(curve.name, row, width);
  text += target_lines(summary, width) + "\n";
  for (const std::string& verdict : verdicts(summary)) text += verdict + "\n";
  return text;
}

std::string csv_table(const Summary& summary) {
  std::string text =
      "settings,samples,samples_per_pixel,seeds,cpu_seconds,mse,mse_standard_error,relative_mse,"
      "bias,bias_standard_error,reference_mean,p_value,tiles";
  for (const Target& target : summary.curves.front().targets)
    text +=
        fmt::format(",cpu_seconds_to_rmse_{0:g},is_extrapolated_{0:g},samples_to_rmse_{0:g}", target.rmse);
  text += "\n";
  for (const CurveSummary& curve : summary.curves)
    for (const Row& row : curve.rows) text += csv_row(row, curve);
  return text;
}

}  // namespace twinray::error

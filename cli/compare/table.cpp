// SPDX-License-Identifier: Apache-2.0
#include "cli/compare/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace twinray::compare {
namespace {

constexpr std::array<const char*, 3> channel_names{"red", "green", "blue"};

template <class Cell>
ChannelRow row_of(const std::string& name, const PictureDifference& difference, const Cell& cell) {
  ChannelRow row{name, {cell(difference.all), {}, {}, {}}};
  for (std::size_t i = 0; i < 3; ++i) row.cells[i + 1] = cell(difference.channels[i]);
  return row;
}

std::string number(double value) { return fmt::format("{:.4g}", value); }

/// The mean signed error as a part of the reference's mean.
std::string percent(const ChannelDifference& one) {
  return one.reference_mean > 0 ? fmt::format("{:+.3g} %", 100 * one.mean / one.reference_mean) : "-";
}

std::string largest_text(const PixelDifference& largest) {
  return largest.value == 0 ? "none"
                            : fmt::format("{:+.4g} in {} of pixel {} {}", largest.value,
                                          channel_names[largest.channel], largest.x, largest.y);
}

std::string psnr_text(const Comparison& comparison) {
  return comparison.psnr ? fmt::format("{:.2f} dB", *comparison.psnr) : "no difference in 8 bits";
}

/// "p = 0.34: noise explains all", "p = 1e-9: 12 of 300 tiles differ by more than noise"
std::string test_text(const BiasTest& test) {
  const auto rejected = std::count_if(test.tiles.begin(), test.tiles.end(),
                                      [&](const TileTest& one) { return is_rejected(one.test, test); });
  if (!(test.p_value < test_level))
    return fmt::format("p = {:.2g}: noise explains the difference", test.p_value);
  return fmt::format("p = {:.2g}: {} of {} tiles differ by more than noise", test.p_value, rejected,
                     test.tiles.size());
}

}  // namespace

std::string pixels_text(const Comparison& comparison) {
  const std::size_t differing = comparison.difference.differing_pixels;
  return fmt::format("{} x {} pixels of {}, {}", comparison.reference.width, comparison.reference.height,
                     comparison.is_radiance ? "radiance" : "what a display shows",
                     differing == 0 ? "all equal" : fmt::format("{} of them differ", differing));
}

std::vector<ChannelRow> channel_rows(const Comparison& comparison) {
  const PictureDifference& all = comparison.difference;
  using One = const ChannelDifference&;
  return {row_of("mean squared error", all, [](One one) { return number(one.squared.mse); }),
          row_of("its root", all, [](One one) { return number(std::sqrt(one.squared.mse)); }),
          row_of("relative MSE", all, [](One one) { return number(one.squared.relative); }),
          row_of("mean signed error", all, [](One one) { return fmt::format("{:+.4g}", one.mean); }),
          row_of("of the mean", all, percent)};
}

std::vector<std::pair<std::string, std::string>> other_rows(const Comparison& comparison) {
  std::vector<std::pair<std::string, std::string>> rows{
      {comparison.is_radiance ? "FLIP (HDR)" : "FLIP",
       fmt::format("{:.4f} in the mean, {:.4f} at most", comparison.mean_flip, comparison.largest_flip)}};
  if (!comparison.is_radiance) rows.emplace_back("PSNR", psnr_text(comparison));
  if (comparison.test) rows.emplace_back("Welch's test", test_text(*comparison.test));
  rows.emplace_back("largest difference", largest_text(comparison.difference.largest));
  return rows;
}

const std::vector<std::string>& tile_heads() {
  static const std::vector<std::string> heads{"tile", "x", "y", "root of MSE", "luminance"};
  return heads;
}

std::vector<std::string> tile_cells(const TileDifference& one) {
  return {fmt::format("{} x {}", one.tile.width(), one.tile.height()), fmt::format("{}", one.tile.x0),
          fmt::format("{}", one.tile.y0), number(std::sqrt(one.mse)), fmt::format("{:+.4g}", one.luminance)};
}

std::string text_table(const Comparison& comparison) {
  std::string text =
      fmt::format("{} against {}: {}\n\n{:<18}  {:>11}  {:>11}  {:>11}  {:>11}\n", comparison.picture_name,
                  comparison.reference_name, pixels_text(comparison), "", "all", "red", "green", "blue");
  for (const auto& [name, cells] : channel_rows(comparison))
    text +=
        fmt::format("{:<18}  {:>11}  {:>11}  {:>11}  {:>11}\n", name, cells[0], cells[1], cells[2], cells[3]);
  for (const auto& [name, value] : other_rows(comparison)) text += fmt::format("{:<18}  {}\n", name, value);
  if (comparison.tiles.empty()) return text;
  const auto line = [](const std::vector<std::string>& cells) {
    return fmt::format("{:<7}  {:>6}  {:>6}  {:>11}  {:>11}\n", cells[0], cells[1], cells[2], cells[3],
                       cells[4]);
  };
  text += "\nWhere they differ most:\n" + line(tile_heads());
  for (const TileDifference& one : comparison.tiles) text += line(tile_cells(one));
  return text;
}

}  // namespace twinray::compare

// SPDX-License-Identifier: Apache-2.0
// A comparison in words and numbers: the same on standard output and on the page.
#pragma once
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "cli/compare/comparison.h"

namespace twinray::compare {

/// "480 x 360 pixels of radiance, 1234 of them differ".
std::string pixels_text(const Comparison& comparison);

/// A measure of all channels together, and of red, green and blue.
struct ChannelRow {
  std::string name;
  std::array<std::string, 4> cells;
};
std::vector<ChannelRow> channel_rows(const Comparison& comparison);

/// Names and values of what is not by channel: FLIP, PSNR, the largest difference.
std::vector<std::pair<std::string, std::string>> other_rows(const Comparison& comparison);

/// The heads of the table of tiles, and the cells of a row.
const std::vector<std::string>& tile_heads();
std::vector<std::string> tile_cells(const TileDifference& tile);

/// All of it.
std::string text_table(const Comparison& comparison);

}  // namespace twinray::compare

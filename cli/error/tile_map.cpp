// SPDX-License-Identifier: Apache-2.0
#include "cli/error/tile_map.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/elementary.h"
#include "io/display/color_scale.h"

namespace twinray::error {
namespace {

/// The p-value, as a power of two, from which on a colour is full.
constexpr double strongest = 20;

}  // namespace

std::string tile_color(const WelchTest& test) {
  const double strength = test.p_value > 0 ? std::min(1.0, -log2_of(test.p_value) / strongest) : 1;
  const auto [r, g, b] = signed_color(test.t > 0 ? strength : -strength);
  return fmt::format("#{:02x}{:02x}{:02x}", r, g, b);
}

std::string tile_map(const BiasTest& test) {
  const PixelRect& frame = test.whole.tile;
  std::string body =
      fmt::format("<rect width=\"{}\" height=\"{}\" fill=\"#ddd\"/>", frame.width(), frame.height());
  for (const TileTest& one : test.tiles) {
    body += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"{}><title>{:+.2f} %, p = "
        "{:.2g}</title></rect>",
        one.tile.x0, one.tile.y0, one.tile.width(), one.tile.height(), tile_color(one.test),
        is_rejected(one.test, test) ? " stroke=\"#111\"" : "",
        one.converged.mean > 0 ? 100 * (one.picture.mean / one.converged.mean - 1) : 0, one.test.p_value);
  }
  return fmt::format(
      "<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"where the means differ\">{}</svg>\n",
      frame.width(), frame.height(), body);
}

}  // namespace twinray::error

// SPDX-License-Identifier: Apache-2.0
#include "cli/compare/page.h"

#include <fmt/format.h>

#include "cli/compare/maps.h"
#include "cli/compare/table.h"
#include "cli/error/tile_map.h"
#include "cli/version.h"
#include "io/html/page.h"
#include "io/html/picture_address.h"
#include "io/html/slider.h"

namespace twinray::compare {
namespace {

html::Picture displayed(const std::string& name, const Image& image) {
  return {name, html::picture_address(encode_srgb(image)), image.width};
}

std::string facts(const Comparison& comparison, const std::string& command) {
  return html::facts({{"command", command},
                      {"picture", comparison.picture_name},
                      {"reference", comparison.reference_name},
                      {"pictures", pixels_text(comparison)},
                      {"program", version_name()}});
}

std::string measures(const Comparison& comparison) {
  std::string rows;
  for (const ChannelRow& row : channel_rows(comparison)) {
    std::vector<std::string> cells{row.name};
    cells.insert(cells.end(), row.cells.begin(), row.cells.end());
    rows += html::row(cells);
  }
  return html::table({"", "all", "red", "green", "blue"}, rows) + html::facts(other_rows(comparison));
}

/// Frames around the listed tiles, with their numbers.
std::string tile_frames(const Comparison& comparison) {
  std::string frames;
  for (std::size_t i = 0; i < comparison.tiles.size(); ++i) {
    const PixelRect& tile = comparison.tiles[i].tile;
    frames += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#111\" "
        "vector-effect=\"non-scaling-stroke\"><title>{}</title></rect>",
        tile.x0, tile.y0, tile.width(), tile.height(), i + 1);
  }
  return frames;
}

std::string signed_map(const Comparison& comparison) {
  const double full = full_difference(comparison.picture, comparison.reference);
  const int width = comparison.reference.width, height = comparison.reference.height;
  const std::string address =
      html::picture_address(signed_picture(comparison.picture, comparison.reference, full));
  return fmt::format(
      "<figure><figcaption>Luminance: red is brighter than the reference, blue darker</figcaption>"
      "<svg class=\"map\" viewBox=\"0 0 {0} {1}\" role=\"img\" aria-label=\"signed differences\">"
      "<image width=\"{0}\" height=\"{1}\" href=\"{2}\"/>{3}</svg><small><span>full colour from a difference "
      "of {4:.3g} on</span><span>frames: the tiles of the table</span></small></figure>\n",
      width, height, address, tile_frames(comparison), full);
}

std::string flip_map(const Comparison& comparison) {
  return fmt::format(
      "<figure><figcaption>FLIP: how much of a difference people see</figcaption><img class=\"fine\" alt=\"a "
      "map of FLIP\" src=\"{}\"><img class=\"scale\" alt=\"its scale\" src=\"{}\"><small><span>0</span>"
      "<span>1</span></small></figure>\n",
      html::picture_address(flip_picture(comparison.flip)), html::picture_address(flip_scale()));
}

/// By Welch's test, where there is one.
std::string p_value_map(const Comparison& comparison) {
  if (!comparison.test) return "";
  return "<figure><figcaption>Welch's test: the fuller the colour, the less likely by noise</figcaption>" +
         error::tile_map(*comparison.test) +
         "<small><span>red is brighter than the reference, blue darker</span><span>frames: more than noise, "
         "at "
         "1 % for all tiles together</span></small></figure>\n";
}

std::string tiles(const Comparison& comparison) {
  if (comparison.tiles.empty()) return "";
  std::string rows;
  for (const TileDifference& one : comparison.tiles) rows += html::row(tile_cells(one));
  return "<h2>Where they differ most</h2>\n" + html::table(tile_heads(), rows);
}

constexpr const char* meanings = R"(<p>Errors are of linear colours, over pixels and channels. The relative
error divides each squared difference by the reference's square plus 0.01. The mean signed error is above 0
where the picture is brighter than the reference; below it stands as a part of the reference's mean. FLIP is
that of Andersson et al. (2020; of radiance 2021), at 67 pixels per degree.</p>
)";

}  // namespace

std::string compare_page(const Comparison& comparison, const std::string& command) {
  const std::string body = facts(comparison, command) + "<h2>Picture and reference</h2>\n" +
                           html::slider(displayed(comparison.picture_name, comparison.picture),
                                        displayed(comparison.reference_name, comparison.reference)) +
                           "<h2>Differences</h2>\n" + measures(comparison) + meanings +
                           "<div class=\"plots\">" + flip_map(comparison) + signed_map(comparison) +
                           p_value_map(comparison) + "</div>\n" + tiles(comparison);
  return html::page(fmt::format("{} against {}", comparison.picture_name, comparison.reference_name), body);
}

}  // namespace twinray::compare

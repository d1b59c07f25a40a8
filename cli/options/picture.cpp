// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <optional>

#include "cli/console.h"
#include "cli/options/render.h"
#include "cli/render_outputs.h"

namespace twinray {
namespace {

constexpr FilterKind all_filters[] = {FilterKind::box, FilterKind::triangle, FilterKind::gaussian,
                                      FilterKind::blackman_harris, FilterKind::mitchell};

/// All but one of them.
std::string filter_names(const char* separator, std::optional<FilterKind> but = {}) {
  Words names;
  for (const FilterKind kind : all_filters)
    if (kind != but) names.push_back(filter_name(kind));
  return fmt::format("{}", fmt::join(names, separator));
}

PixelRect window_of(const std::vector<int>& crop, int width, int height) {
  const int x = crop[0], y = crop[1], w = crop[2], h = crop[3];
  if (x < 0 || y < 0 || w < 1 || h < 1 || w > width || h > height || x > width - w || y > height - h)
    throw UsageError(fmt::format("--crop: {} {} {} {} (X Y W H) is not a part of {} x {} pixels", x, y, w, h,
                                 width, height));
  return {x, y, x + w, y + h};
}

/// "12" or "5%"
Overscan parse_overscan(const std::string& word) {
  constexpr Range<int> pixels{0, 16384};
  constexpr Range<double> percents{0, 100};
  const bool is_percent = word.ends_with('%');
  if (is_percent) return {parse_number("--overscan", word.substr(0, word.size() - 1), percents), true};
  return {double(parse_number("--overscan", word, pixels)), false};
}

/// The frame and what lies around it.
PixelRect window_of(const Overscan& overscan, int width, int height) {
  const auto pixels = [&overscan](int side) {
    const auto [amount, is_percent] = overscan;
    return int(std::ceil(is_percent ? side * amount / 100 : amount));
  };
  const int x = pixels(width), y = pixels(height);
  return {-x, -y, width + x, height + y};
}

/// "gaussian:1.5"
PixelFilter parse_filter(const std::string& word) {
  const std::size_t colon = word.find(':');
  const std::string name = word.substr(0, colon);
  for (const FilterKind kind : all_filters) {
    if (filter_name(kind) != name) continue;
    if (colon == word.npos) return usual_filter(kind);
    constexpr Range<float> radii{least_filter_radius, most_filter_radius};
    return filter_of_radius(kind, parse_number("--filter", word.substr(colon + 1), radii));
  }
  throw UsageError(fmt::format("--filter: there is no \"{}\"; valid are {}", name, filter_names(", ")));
}

/// What neither a file nor an option chooses is Blackman and Harris's; CS184's program has no such option.
void add_filter(OptionGroup& group, PixelFilter& filter) {
  filter = usual_filter(FilterKind::blackman_harris);
  group.add_words(
      {"--filter", "NAME[:RADIUS]",
       fmt::format("{} ({})", filter_names(" ", filter.kind), filter_text(filter)), filter_text(filter)},
      1, [&filter](const Words& words) { filter = parse_filter(words[0]); });
}

}  // namespace

void add_picture_options(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, option_groups::picture);
  RenderArguments& arguments = request.arguments;
  group.add_word({"-o,--output,-f", "FILE",
                  fmt::format("The picture: .png .jpg .exr .tif .hdr .pfm, - ({})", arguments.output)},
                 arguments.output);
  add_frame_options(app, request);
  group.add_words({"--overscan", "N|P%", "So many more pixels on each side of an .exr"}, 1,
                  [&arguments](const Words& words) { arguments.overscan = parse_overscan(words[0]); });
}

void add_frame_options(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, option_groups::picture);
  RenderArguments& arguments = request.arguments;
  add_resolution(group, arguments.render.width, arguments.render.height, "Width and height in pixels");
  constexpr Range<int> any{std::numeric_limits<int>::min(), std::numeric_limits<int>::max()};
  group.add_numbers({"-p,--crop", "X Y W H", "Only this part of the frame, from its top left"}, 4,
                    arguments.crop, any);
  add_view(group, arguments.view);
  add_filter(group, arguments.render.filter);
  add_camera_options(app, request);
}

void resolve_picture(RenderArguments& arguments) {
  RenderOptions& render = arguments.render;
  const bool is_sized = is_given("--resolution", arguments) || !has_defaults(arguments.scene);
  if (is_sized && !arguments.crop.empty())
    render.window = window_of(arguments.crop, render.width, render.height);
  if (is_sized && arguments.overscan)
    render.window = window_of(*arguments.overscan, render.width, render.height);
}

void resolve_overscan(const RenderArguments& arguments) {
  if (!arguments.overscan || arguments.replay) return;
  if (!arguments.crop.empty()) throw UsageError("--overscan and --crop exclude each other");
  if (!keeps_layers(arguments.output))
    throw UsageError(fmt::format("--overscan: {} cannot tell a frame from what is around it; an .exr can",
                                 arguments.output));
}

void take_frame(const RenderDefaults& defaults, RenderArguments& arguments) {
  RenderOptions& render = arguments.render;
  if (defaults.resolution && !is_given("--resolution", arguments)) {
    render.width = defaults.resolution->width;
    render.height = defaults.resolution->height;
  }
  if (const auto crop = defaults.crop_of({render.width, render.height}); crop && arguments.crop.empty()) {
    if (arguments.overscan)
      console::warn("--overscan: the whole frame is rendered, not the part that the scene file names");
    else
      arguments.crop.assign(crop->begin(), crop->end());
  }
  if (defaults.filter && !is_given("--filter", arguments)) render.filter = *defaults.filter;
  if (!arguments.crop.empty()) render.window = window_of(arguments.crop, render.width, render.height);
  if (arguments.overscan) render.window = window_of(*arguments.overscan, render.width, render.height);
}

}  // namespace twinray

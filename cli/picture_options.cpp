// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "cli/render_options.h"

namespace twinray {
namespace {

constexpr const char* group_name = "Picture and samples";

PixelRect window_of(const std::vector<int>& crop, int width, int height) {
  const int x = crop[0], y = crop[1], w = crop[2], h = crop[3];
  if (x < 0 || y < 0 || w < 1 || h < 1 || w > width || h > height || x > width - w || y > height - h)
    throw UsageError(fmt::format("--crop: {} {} {} {} (X Y W H) is not a part of {} x {} pixels", x, y, w, h,
                                 width, height));
  return {x, y, x + w, y + h};
}

}  // namespace

void add_picture_options(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, group_name);
  RenderArguments& arguments = request.arguments;
  group.add_word({"-o,--output,-f", "FILE",
                  fmt::format("The picture: .png, .exr (linear floats) or - ({})", arguments.output)},
                 arguments.output);
  add_frame_options(app, request);
}

void add_frame_options(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, group_name);
  RenderArguments& arguments = request.arguments;
  add_resolution(group, arguments.render.width, arguments.render.height, "Width and height in pixels");
  constexpr Range<int> any{std::numeric_limits<int>::min(), std::numeric_limits<int>::max()};
  group.add_numbers({"-p,--crop", "X Y W H", "Only this part of the frame, from its top left"}, 4,
                    arguments.crop, any);
  add_view(group, arguments.view);
  group.add_choice<bool>("--clip", arguments.load.clip_as_file, {{"none", false}, {"file", true}},
                         "Whether the file's clip distances cut the view");
  group.add_word({"-c,--camera", "FILE", "Camera settings file of CS184's program"}, arguments.camera_file);
  group.add_word({"--camera-name", "NAME", "A camera of the scene file, by name or id; ? lists them"},
                 arguments.load.camera_name);
}

void resolve_picture(RenderArguments& arguments) {
  RenderOptions& render = arguments.render;
  const bool is_sized = is_given("--resolution", arguments) || !has_defaults(arguments.scene);
  if (is_sized && !arguments.crop.empty())
    render.window = window_of(arguments.crop, render.width, render.height);
}

void take_frame(const RenderDefaults& defaults, RenderArguments& arguments) {
  RenderOptions& render = arguments.render;
  if (defaults.resolution && !is_given("--resolution", arguments)) {
    render.width = defaults.resolution->width;
    render.height = defaults.resolution->height;
    if (arguments.crop.empty() && defaults.crop)
      arguments.crop.assign(defaults.crop->begin(), defaults.crop->end());
  }
  if (!arguments.crop.empty()) render.window = window_of(arguments.crop, render.width, render.height);
}

}  // namespace twinray

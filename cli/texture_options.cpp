// SPDX-License-Identifier: Apache-2.0
#include "cli/render_options.h"

namespace twinray {

void add_texture_options(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, "Light");
  group.add_choice<std::optional<TextureFilter>>("--texture-filter", request.arguments.texture_filter,
                                                 {{"stochastic", TextureFilter::stochastic},
                                                  {"trilinear", TextureFilter::trilinear},
                                                  {"bilinear", TextureFilter::bilinear},
                                                  {"nearest", TextureFilter::nearest},
                                                  {"file", std::nullopt}},
                                                 "Of pictures on surfaces; file: as it says", "FILTER");
}

}  // namespace twinray

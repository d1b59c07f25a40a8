// SPDX-License-Identifier: Apache-2.0
#include "cli/options/render.h"

namespace twinray {
namespace {

constexpr Range<double> texture_megabytes{0, 1e9};

}  // namespace

void add_texture_options(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, option_groups::light);
  group.add_choice<std::optional<TextureFilter>>("--texture-filter", request.arguments.texture_filter,
                                                 {{"stochastic", TextureFilter::stochastic},
                                                  {"trilinear", TextureFilter::trilinear},
                                                  {"bilinear", TextureFilter::bilinear},
                                                  {"nearest", TextureFilter::nearest},
                                                  {"file", std::nullopt}},
                                                 "Of pictures on surfaces; file: as it says", "FILTER");
  group.add_words({"--texture-memory", "MB", "Of pictures on surfaces, at most in memory (all)"}, 1,
                  [&request](const Words& words) {
                    const double megabytes =
                        parse_number("--texture-memory", words.front(), texture_megabytes);
                    request.arguments.texture_bytes = std::uint64_t(1e6 * megabytes);
                  });
  group.add_flag("--convert-textures", request.arguments.convert_textures,
                 "Write them as .tx beside themselves, and render nothing");
}

}  // namespace twinray

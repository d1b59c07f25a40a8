// SPDX-License-Identifier: Apache-2.0
// --denoise: what takes the noise out of the picture.
#include "cli/options/render.h"

namespace twinray {
namespace {

DenoiserKind denoiser_named(const std::string& name) {
  if (name == "auto") return DenoiserKind::automatic;
  if (name == "oidn") return DenoiserKind::open_image_denoise;
  if (name == "own") return DenoiserKind::own;
  throw UsageError(fmt::format("--denoise: there is no \"{}\"; valid are auto, oidn, own", name));
}

}  // namespace

void add_denoise_options(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, option_groups::picture);
  group.add_optional_word({"--denoise", "[=auto|oidn|own]", "By Open Image Denoise, else by our own filter"},
                          "auto", request.denoise);
  group.add_flag("--denoise-light-groups", request.denoise_light_groups,
                 "Each group by itself; the picture is their sum");
}

void resolve_denoising(const RenderRequest& request, RenderArguments& arguments) {
  if (request.denoise.empty()) return;
  arguments.denoiser = denoiser_named(request.denoise);
  if (!traces_paths(arguments.integrator))
    throw UsageError(
        fmt::format("--denoise: --integrator={} knows no features of surfaces; path, path-reference and "
                    "direct do",
                    integrator_name(arguments.integrator)));
  arguments.render.half_layers = {Layer::albedo, Layer::normal};
  arguments.render.half_light_groups = request.denoise_light_groups && arguments.render.light_groups;
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "cli/verify/claim.h"

#include <fmt/format.h>

#include "cli/cs184/options.h"
#include "cli/options/common.h"
#include "cli/render_command_line.h"
#include "cli/shell_text.h"
#include "core/error.h"

namespace twinray {
namespace {

/// Why a picture with these metadata cannot be made again by its command alone; empty: it can.
std::string obstacle(const ImageMetadata& metadata) {
  if (value_of(metadata, "twinray:options").empty() || value_of(metadata, "twinray:inputs").empty())
    return "it does not say how it was made; pictures do that render or merge has written as .png or .exr";
  if (const std::string relit = value_of(metadata, "twinray:relit"); !relit.empty())
    return fmt::format("its lights were mixed anew by `{}`; the picture before that can be verified", relit);
  if (const std::string missing = value_of(metadata, "twinray:missing"); !missing.empty())
    return fmt::format("it was merged without {}", missing);
  if (const std::string shown = value_of(metadata, "twinray:shows"); !shown.empty())
    return fmt::format("it shows the {} of another picture, which can be verified", shown);
  const std::string samples = value_of(metadata, "twinray:samples");
  if (samples.find_first_not_of("0123456789") != samples.npos)
    return fmt::format("it is what an interrupted render left: {} samples a pixel", samples);
  return "";
}

}  // namespace

PictureClaim read_claim(const std::string& path, const ImageMetadata& metadata) {
  if (const std::string reason = obstacle(metadata); !reason.empty())
    throw Error(fmt::format("{}: {}", path, reason));
  const auto value = [&](const char* name) { return value_of(metadata, name); };
  return {.program = value("Software"),
          .is_cs184 = value("twinray:program") == "pathtracer",
          .words = words_of(value("twinray:options")),
          .samples = parse_number(path + ": twinray:samples", value("twinray:samples"), sample_counts),
          .engine = value("twinray:engine"),
          .inputs = parse_input_text(value("twinray:inputs")),
          .is_denoised = !value("twinray:denoiser").empty()};
}

RenderArguments arguments_of(const PictureClaim& claim) {
  Words words = claim.words;
  std::erase(words, "--strict");
  std::erase(words, "--resume");
  RenderArguments arguments = claim.is_cs184 ? parse_cs184_arguments(words) : parse_render_arguments(words);
  RenderOptions& render = arguments.render;
  if (claim.samples == 1 && is_open_ended(render)) {
    // A pixel's only sample lies in its middle. This one was the first of several.
    render.range = {0, 1};
    render.adaptive.reset();
    render.allocation = Allocation::even;
  } else {
    render.samples = claim.samples;
  }
  render.seconds.reset();
  render.noise_target.reset();
  render.half_layers.reset();
  render.half_light_groups = false;
  arguments.until.reset();
  arguments.denoiser.reset();
  arguments.check_with.reset();
  arguments.stats_file.clear();
  arguments.metrics_file.clear();
  arguments.checkpoint.clear();
  arguments.viewer.reset();
  arguments.server.reset();
  if (!is_given("--samples", arguments)) arguments.given.push_back("--samples");
  return arguments;
}

}  // namespace twinray

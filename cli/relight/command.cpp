// SPDX-License-Identifier: Apache-2.0
#include "cli/relight/command.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <sstream>

#include "cli/console.h"
#include "cli/interrupt.h"
#include "cli/layered_picture.h"
#include "cli/outputs.h"
#include "cli/shell_text.h"
#include "core/error.h"
#include "io/picture/image_file.h"
#include "io/picture/output_format.h"

namespace twinray {
namespace {

constexpr const char* option = "--light";
constexpr Range<float> factors{0, 1e6f};

/// The options as they are read.
struct RelightRequest {
  RelightArguments arguments;
  Words changes;
};

void add_options(CLI::App& app, RelightRequest& request) {
  add_file(app, "PICTURE", request.arguments.picture, "A picture rendered with --layers=light-groups: .exr");
  OptionGroup group(app, "Options");
  group.add_repeated({option, "GROUP=COLOR", "Its light, times R,G,B or one number; 0 turns it off"},
                     request.changes);
  group.add_word(
      {"-o,--output", "FILE", "The picture; .exr keeps its layers. Without it the groups are listed"},
      request.arguments.output);
  group.add_flag("-q,--quiet", request.arguments.quiet, "Do not say what was changed");
}

/// Only an EXR tells a frame from what is rendered around it (docs/camera.md, Overscan).
void check_frame(const StoredLayers& picture, const std::string& output) {
  const ImageFrame& frame = picture.frame;
  const bool is_around =
      frame.width > 0 && (frame.x < 0 || frame.y < 0 || frame.x + picture.width > frame.width ||
                          frame.y + picture.height > frame.height);
  if (is_around && !output.empty() && output_format(output) != OutputFormat::exr)
    throw Error(
        fmt::format("{}: it cannot tell the picture's frame from what is around it; an .exr can", output));
}

/// Whether the picture is denoised, and its groups are not: then their sum is the noisy picture.
bool is_denoised_alone(const StoredLayers& picture) {
  const auto has = [&](const std::string& prefix) {
    return std::any_of(picture.channels.begin(), picture.channels.end(),
                       [&](const PictureChannel& channel) { return channel.name.starts_with(prefix); });
  };
  return has("noisy.") && !has("noisy_" + light_group_layer(""));
}

/// Whether it says something of layers, which most pictures have none of.
bool is_of_layers(const std::string& name) {
  return name.starts_with("cryptomatte/") || name == "twinray:object_id" || name == "twinray:material_id";
}

/// What a file says of its pixels, but for what it says of itself.
ImageMetadata carried(const ImageMetadata& stored, const Words& words, bool has_layers) {
  ImageMetadata metadata;
  for (const auto& [name, value] : stored)
    if (!name.starts_with("oiio:") && !name.starts_with("openexr:") && name != "compression" &&
        (has_layers || !is_of_layers(name)))
      metadata.emplace_back(name, value);
  metadata.emplace_back("twinray:relit", "twinray relight " + shell_text(words));
  return metadata;
}

LayeredImage layered(const StoredLayers& stored) {
  const std::size_t row = std::size_t(stored.width) * stored.channels.size();
  return {stored.width, stored.height, stored.channels, [&stored, row](int y, std::span<float> values) {
            std::copy_n(stored.values.begin() + std::ptrdiff_t(std::size_t(y) * row), row, values.begin());
          }};
}

void write(const StoredLayers& picture, const RelightArguments& arguments, const Words& words) {
  const bool has_layers = output_format(arguments.output) == OutputFormat::exr;
  const ImageMetadata metadata = carried(picture.metadata, words, has_layers);
  if (has_layers)
    write_exr(arguments.output, layered(picture), metadata, picture.frame);
  else
    write_image(arguments.output, colors_of(picture), metadata, picture.frame);
}

/// Throws UsageError for a group that has its change already.
void add_change(const LightChange& change, std::vector<LightChange>& changes) {
  for (const LightChange& other : changes)
    if (other.group == change.group)
      throw UsageError(fmt::format("{}: {} is named twice", option, change.group));
  changes.push_back(change);
}

}  // namespace

LightChange parse_light_change(const std::string& text) {
  const std::size_t equals = text.find('=');
  Words numbers;
  if (equals != text.npos) {
    std::istringstream list(text.substr(equals + 1));
    for (std::string number; std::getline(list, number, ',');) numbers.push_back(number);
  }
  if (equals == 0 || (numbers.size() != 1 && numbers.size() != 3))
    throw UsageError(fmt::format("{}: \"{}\" is no change; valid are GROUP=X and GROUP=R,G,B", option, text));
  const auto factor = [&](std::size_t i) {
    return parse_number(option, numbers[i % numbers.size()], factors);
  };
  return {text.substr(0, equals), {factor(0), factor(1), factor(2)}};
}

std::function<RelightArguments()> add_relight_options(CLI::App& app) {
  const auto request = std::make_shared<RelightRequest>();
  add_options(app, *request);
  return [request] {
    RelightArguments arguments = request->arguments;
    for (const std::string& text : request->changes) add_change(parse_light_change(text), arguments.changes);
    if (arguments.output.empty() && !arguments.changes.empty())
      throw UsageError("--light: where to? --output=FILE is missing");
    if (!arguments.output.empty()) check_image_name(arguments.output);
    return arguments;
  };
}

int relight_command(const RelightArguments& arguments, const Words& words) {
  const std::vector<std::string> outputs = given_names({arguments.output});
  const InterruptGuard guard(outputs);
  prepare_outputs(outputs, {arguments.picture});
  StoredLayers picture = read_layers(arguments.picture);
  if (const std::string parts = unread_parts(arguments.picture); !parts.empty()) console::warn(parts);
  check_frame(picture, arguments.output);
  const bool is_noisy_again = is_denoised_alone(picture);
  relight(picture, arguments.changes, arguments.picture);
  const std::vector<std::string> groups = light_groups_of(picture);
  if (arguments.output.empty()) {
    for (const std::string& group : groups) console::print("{}\n", group);
    return 0;
  }
  if (is_noisy_again) {
    std::erase_if(picture.metadata, [](const auto& entry) { return entry.first == "twinray:denoiser"; });
    console::warn(
        fmt::format("{}: its light groups are not denoised, and neither is their sum; to denoise them, too, "
                    "render it with --denoise-light-groups",
                    arguments.picture));
  }
  write(picture, arguments, words);
  if (!arguments.quiet)
    console::print("{}: {} changes, of {} light groups\n", arguments.output, arguments.changes.size(),
                   groups.size());
  return 0;
}

}  // namespace twinray

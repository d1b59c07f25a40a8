// SPDX-License-Identifier: Apache-2.0
// --layers: what a picture shows beside its colours.
#include <algorithm>
#include <sstream>

#include "cli/render_options.h"
#include "io/image_file.h"

namespace twinray {
namespace {

constexpr const char* default_output = "twinray.exr";

constexpr const char* parts_name = "light";  ///< Of all the parts of the colours: one makes no sense alone.

bool is_part(Layer layer) { return layer_info(layer).gathering == Gathering::part; }

Words valid_names() {
  Words names{"all"};
  for (const Layer layer : all_layers())
    if (!is_part(layer)) names.push_back(layer_info(layer).name);
  names.push_back(parts_name);
  return names;
}

/// The layers of one word, which may stand for several.
std::vector<Layer> layers_of(const std::string& name) {
  if (name == "all") return all_layers();
  if (name == parts_name) return light_parts();
  for (const Layer layer : all_layers())
    if (name == layer_info(layer).name && !is_part(layer)) return {layer};
  throw UsageError(fmt::format("--layers: there is no \"{}\"; valid are {}, one or several with commas", name,
                               fmt::join(valid_names(), ", ")));
}

/// Each once, in the order in which files have them; alpha belongs to the colours.
std::vector<Layer> parse_layers(const std::string& names) {
  std::vector<Layer> layers{Layer::alpha};
  std::istringstream list(names);
  for (std::string name; std::getline(list, name, ',');)
    for (const Layer layer : layers_of(name)) layers.push_back(layer);
  std::sort(layers.begin(), layers.end());
  layers.erase(std::unique(layers.begin(), layers.end()), layers.end());
  return layers;
}

}  // namespace

void add_layer_options(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, "Picture and samples");
  group.add_words(
      {"--layers", "NAME,...", "More layers in an .exr: albedo, normal, ids, ... or all"}, 1,
      [&request](const Words& words) { request.arguments.render.layers = parse_layers(words.front()); });
}

void resolve_layers(RenderArguments& arguments) {
  if (arguments.render.layers.empty()) return;
  if (!is_given("--output", arguments)) arguments.output = default_output;
  if (!arguments.replay && output_format(arguments.output) != OutputFormat::exr)
    throw UsageError(
        fmt::format("--layers: {} cannot hold layers; the name of a picture that can ends in "
                    ".exr",
                    arguments.output));
  if (!traces_paths(arguments.integrator))
    throw UsageError(
        fmt::format("--layers: --integrator={} knows of none; path, path-reference and direct do",
                    integrator_name(arguments.integrator)));
}

}  // namespace twinray

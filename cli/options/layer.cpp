// SPDX-License-Identifier: Apache-2.0
// --layers: what a picture shows beside its colours.
#include <algorithm>
#include <sstream>

#include "cli/options/render.h"
#include "cli/render_outputs.h"
#include "core/error.h"
#include "io/picture/image_file.h"

namespace twinray {
namespace {

constexpr const char* default_output = "twinray.exr";

// What stands for several layers.
constexpr const char* everything = "all";
constexpr const char* light_paths = "light";
constexpr const char* light_groups = "light-groups";
constexpr const char* mattes = "cryptomatte";

Words valid_names() {
  Words names{everything};
  for (const Layer layer : all_layers()) names.push_back(layer_info(layer).name);
  names.insert(names.end(), {mattes, light_paths, light_groups});
  return names;
}

/// The layers of one word, which may stand for several.
std::vector<Layer> layers_of(const std::string& name) {
  if (name == everything) return all_layers();
  if (name == mattes) return {Layer::object_matte, Layer::material_matte, Layer::asset_matte};
  for (const Layer layer : all_layers())
    if (name == layer_info(layer).name) return {layer};
  throw UsageError(fmt::format("--layers: there is no \"{}\"; valid are {}, one or several with commas", name,
                               fmt::join(valid_names(), ", ")));
}

/// Each once, in the order in which files have them; alpha belongs to the colours.
void parse_layers(const std::string& names, RenderOptions& render) {
  std::vector<Layer>& layers = render.layers;
  layers = {Layer::alpha};
  render.light_paths = render.light_groups = false;
  std::istringstream list(names);
  for (std::string name; std::getline(list, name, ',');) {
    render.light_paths |= name == light_paths || name == everything;
    render.light_groups |= name == light_groups || name == everything;
    if (name == light_paths || name == light_groups) continue;
    for (const Layer layer : layers_of(name)) layers.push_back(layer);
  }
  std::sort(layers.begin(), layers.end());
  layers.erase(std::unique(layers.begin(), layers.end()), layers.end());
}

/// Whether a format's compression keeps what no eye is to see.
bool has_mattes(const RenderOptions& render) {
  return std::any_of(render.layers.begin(), render.layers.end(),
                     [](Layer layer) { return layer_info(layer).gathering == Gathering::coverage; });
}

/// Of layers only colours stay what they are with a loss that is hardly seen.
void check_dwab(const RenderOptions& render) {
  const auto fail = [](const std::string& what) {
    throw UsageError(
        fmt::format("--exr-compression: dwab changes numbers, and with them the {}; zip does not", what));
  };
  if (has_mattes(render)) fail("ids of cryptomatte");
  for (const Layer layer : render.layers) {
    const LayerInfo& info = layer_info(layer);
    const bool is_changed = std::any_of(info.channels.begin(), info.channels.end(), is_lossy);
    if (is_changed && layer != Layer::albedo) fail(fmt::format("layer {}", info.name));
  }
}

}  // namespace

void add_layer_options(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, option_groups::picture);
  group.add_words({"--layers", "NAME,...", "More layers in an .exr: albedo, normal, ids, ... or all"}, 1,
                  [&request](const Words& words) { parse_layers(words.front(), request.arguments.render); });
  group.add_repeated({"--light-group", "NAME=LIGHT,...", "A layer of light-groups; * is any text of a name"},
                     request.light_groups);
  group.add_choice("--exr-compression", request.arguments.compression,
                   {{"zip", ExrCompression::zip}, {"dwab", ExrCompression::dwab}},
                   "zip loses nothing, dwab is smaller");
}

void resolve_layers(const RenderRequest& request, RenderArguments& arguments) {
  for (const std::string& text : request.light_groups)
    arguments.light_groups.push_back(parse_light_group(text));
  if (arguments.render.layers.empty()) return;
  if (!is_given("--output", arguments)) arguments.output = default_output;
  if (!arguments.replay && !keeps_layers(arguments.output))
    throw UsageError(
        fmt::format("--layers: {} cannot hold layers; the name of a picture that can ends in "
                    ".exr",
                    arguments.output));
  if (!traces_paths(arguments.integrator))
    throw UsageError(
        fmt::format("--layers: --integrator={} knows of none; path, path-reference and direct do",
                    integrator_name(arguments.integrator)));
  if (arguments.compression == ExrCompression::dwab) check_dwab(arguments.render);
}

}  // namespace twinray

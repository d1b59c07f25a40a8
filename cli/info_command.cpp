// SPDX-License-Identifier: Apache-2.0
#include "cli/info_command.h"

#include <algorithm>
#include <memory>

#include "cli/console.h"
#include "cli/info_report.h"
#include "cli/json_names.h"
#include "cli/no_effect.h"
#include "cli/render_command_line.h"
#include "cli/resources.h"

namespace twinray {
namespace {

void add_options(CLI::App& app, InfoArguments& arguments) {
  add_scene(app, arguments.scene);
  OptionGroup group(app, "Options");
  add_resolution(group, arguments.resolution,
                 "Of the picture whose memory is told (the scene's, or 480 360)");
  group.add_word({"--camera-name", "NAME", "A camera of the scene file, by name or id"},
                 arguments.load.camera_name);
  add_instances(group, arguments.load);
  group.add_flag("--strict", arguments.load.strict, "What a scene file says must have an effect");
  group.add_flag("--json", arguments.json, "Print JSON");
}

/// As render takes it by the file's settings and its own defaults.
RenderArguments as_render(const InfoArguments& asked, const RenderDefaults& defaults) {
  Words words{asked.scene};
  if (asked.resolution)
    words.insert(words.end(), {"--resolution", std::to_string(asked.resolution->width),
                               std::to_string(asked.resolution->height)});
  RenderArguments arguments = parse_render_arguments(words);
  arguments.load = asked.load;
  take_defaults(defaults, arguments);
  return arguments;
}

/// Names the options that change nothing in this scene; strict: the first one is an error.
void tell_what_has_no_effect(const RenderArguments& arguments, const SceneSummary& summary) {
  const std::vector<std::string> without_effect = options_without_effect(summary, arguments);
  refuse_if_strict(without_effect, arguments);
  for (const std::string& warning : without_effect) console::warn(warning);
}

std::vector<MemoryNeed> needs_of(RenderArguments arguments, const Scene& scene) {
  choose_engine(*scene.geometry, arguments);
  return memory_needs(arguments, scene);
}

/// Each once, in the order in which they were read.
std::vector<std::string> once(const std::vector<std::string>& files) {
  std::vector<std::string> unique;
  for (const std::string& file : files)
    if (std::find(unique.begin(), unique.end(), file) == unique.end()) unique.push_back(file);
  return unique;
}

}  // namespace

std::function<InfoArguments()> add_info_options(CLI::App& app) {
  const auto arguments = std::make_shared<InfoArguments>();
  add_options(app, *arguments);
  return [arguments] { return *arguments; };
}

int info_command(const InfoArguments& arguments) {
  if (arguments.json) check_json_names({arguments.scene}, "--json");
  LoadOptions options = arguments.load;
  options.files = std::make_shared<std::vector<std::string>>();
  const LoadedScene loaded = load_with_warnings(arguments.scene, options);
  const RenderArguments render = as_render(arguments, loaded.defaults);
  tell_what_has_no_effect(render, loaded.summary);
  SceneInfo info = scene_info(arguments.scene, loaded);
  info.files = once(*options.files);
  if (arguments.json) check_json_names(info.files, "--json");
  info.needs = needs_of(render, loaded.scene);
  console::write(arguments.json ? info_json(info) : info_text(info));
  return 0;
}

}  // namespace twinray

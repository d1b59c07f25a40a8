// SPDX-License-Identifier: Apache-2.0
#include "cli/convert_command.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "cli/console.h"
#include "cli/counted.h"
#include "cli/interrupt.h"
#include "cli/options.h"
#include "cli/outputs.h"
#include "core/error.h"
#include "io/environment_file.h"

namespace twinray {
namespace {

void add_options(CLI::App& app, ConvertArguments& arguments) {
  add_scene(app, arguments.scene);
  add_file(app, "OUT.json", arguments.output, "The JSON file; files of the meshes go beside it");
  OptionGroup group(app, "Options");
  add_resolution(group, arguments.frame.width, arguments.frame.height,
                 "Of the picture that the camera is for");
  add_view(group, arguments.view);
  group.add_word({"--camera-name", "NAME", "A camera of the scene file, by name or id"},
                 arguments.load.camera_name);
  group.add_word({"-e,--environment", "FILE", "Light from a latitude-longitude .exr or .hdr"},
                 arguments.environment);
  add_environment_placement(group, arguments.placement);
  add_instances(group, arguments.load);
  group.add_flag("-q,--quiet", arguments.quiet, "Print errors and warnings only");
}

EnvironmentLight read_environment(const ConvertArguments& arguments) {
  LoadedEnvironment loaded = load_environment(arguments.environment);
  if (!loaded.fault.empty()) throw Error(loaded.fault);
  return placed_environment(std::move(loaded.map), arguments.placement, arguments.environment);
}

Scene load(const ConvertArguments& arguments) {
  Scene scene = load_with_warnings(arguments.scene, arguments.load).scene;
  scene.camera = camera_of(scene, arguments.view, arguments.frame.width, arguments.frame.height);
  if (!arguments.environment.empty()) scene.lights.push_back({"environment", read_environment(arguments)});
  return scene;
}

}  // namespace

std::function<ConvertArguments()> add_convert_options(CLI::App& app) {
  const auto arguments = std::make_shared<ConvertArguments>();
  add_options(app, *arguments);
  return [arguments] { return *arguments; };
}

int convert_command(const ConvertArguments& arguments) {
  check_exchange_name(arguments.output);
  prepare_outputs({arguments.output});
  const Scene scene = load(arguments);
  const std::vector<std::string> files = exchange_files(scene, arguments.output);
  const InterruptGuard guard(files);
  prepare_outputs(files);
  write_exchange(scene, arguments.output, arguments.frame);
  if (!arguments.quiet)
    console::print("{}: {}, {}, {}, {} beside it\n", arguments.output,
                   counted(scene.materials.size(), "material"), counted(scene.lights.size(), "light"),
                   counted(scene.geometry->shapes().size(), "shape"), counted(files.size() - 1, "file"));
  return 0;
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "cli/convert_command.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "cli/console.h"
#include "cli/counted.h"
#include "cli/default_light.h"
#include "cli/interrupt.h"
#include "cli/options/options.h"
#include "cli/outputs.h"
#include "core/error.h"
#include "io/picture/environment_file.h"
#include "io/scene_writer.h"

namespace twinray {
namespace {

constexpr RenderDefaults::Resolution default_resolution{480, 360};

void add_options(CLI::App& app, ConvertArguments& arguments) {
  add_scene(app, arguments.scene);
  add_file(app, "OUT", arguments.output, "OUT.json, .pbrt, .gltf or .glb; other files go beside it");
  OptionGroup group(app, "Options");
  add_resolution(group, arguments.resolution,
                 "Of the picture that the camera is for (the scene's, or 480 360)");
  add_view(group, arguments.view);
  group.add_word({"--camera-name", "NAME", "A camera of the scene file, by name or id"},
                 arguments.load.camera_name);
  group.add_number({"--time", "T", "What a glTF file moves stands there then, in seconds (at rest)"},
                   arguments.load.time, Range<double>{-1e9, 1e9});
  group.add_word({"-e,--environment", "FILE", "Light from a latitude-longitude .exr or .hdr"},
                 arguments.environment);
  add_environment_placement(group, arguments.placement);
  add_instances(group, arguments.load);
  group.add_flag("-q,--quiet", arguments.quiet, "Print errors and warnings only");
}

EnvironmentLight read_environment(const ConvertArguments& arguments) {
  LoadedEnvironment loaded = load_environment(arguments.environment);
  if (!loaded.warning.empty()) console::warn(loaded.warning);
  if (!loaded.fault.empty()) throw Error(loaded.fault);
  return placed_environment(std::move(loaded.map), arguments.placement, arguments.environment);
}

/// The scene, and its picture of the size that is asked for or, without one, the file's.
LoadedScene load(const ConvertArguments& arguments, const LoadOptions& options) {
  if (arguments.environment.empty())
    for (const std::string& option : changed_options(arguments.placement))
      console::warn(option + ": no effect, for there is no --environment");
  LoadedScene loaded = load_with_warnings(arguments.scene, options);
  if (arguments.load.time && !loaded.summary.animation)
    console::warn("--time: no effect, for nothing in the scene moves");
  if (loaded.defaults.shutter && !arguments.load.time)
    console::warn("motion is not written: all stands as when the shutter opens; --time=T is another moment");
  RenderDefaults& picture = loaded.defaults;
  if (arguments.resolution) picture.crop = picture.crop_of(*arguments.resolution);
  if (arguments.resolution || !picture.resolution)
    picture.resolution = arguments.resolution.value_or(default_resolution);
  Scene& scene = loaded.scene;
  scene.camera = camera_of(scene, arguments.view, picture.resolution->width, picture.resolution->height);
  if (!arguments.environment.empty()) scene.lights.push_back({"environment", read_environment(arguments)});
  if (loaded.wants_light && !is_lit(scene))
    console::warn(
        "the scene has no light: a render adds a sky and a light at the camera, which are not written");
  return loaded;
}

std::vector<std::string> paths_of(const WrittenScene& written) {
  std::vector<std::string> paths;
  for (const SceneFile& file : written.files) paths.push_back(file.path);
  return paths;
}

}  // namespace

std::function<ConvertArguments()> add_convert_options(CLI::App& app) {
  const auto arguments = std::make_shared<ConvertArguments>();
  add_options(app, *arguments);
  return [arguments] { return *arguments; };
}

int convert_command(const ConvertArguments& arguments) {
  check_scene_output(arguments.output);
  prepare_outputs({arguments.output}, {});
  LoadOptions options = arguments.load;
  options.clip_as_file = true;  // Whoever renders the written scene decides whether it clips.
  options.files = std::make_shared<std::vector<std::string>>();
  const LoadedScene loaded = load(arguments, options);
  const Scene& scene = loaded.scene;
  const WrittenScene written = written_scene({scene, loaded.defaults}, arguments.output);
  const std::vector<std::string> paths = paths_of(written);
  check_not_read(paths, *options.files);
  const InterruptGuard guard(paths, 0, InterruptGuard::Outputs::together);
  prepare_outputs(paths, {});
  write_files(written);
  for (const std::string& warning : written.warnings) console::warn(warning);
  if (!arguments.quiet)
    console::print("{}: {}, {}, {}, {} beside it\n", arguments.output,
                   counted(scene.materials.size(), "material"), counted(scene.lights.size(), "light"),
                   counted(scene.geometry->shapes().size(), "shape"), counted(paths.size() - 1, "file"));
  return 0;
}

}  // namespace twinray

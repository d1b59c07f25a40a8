// SPDX-License-Identifier: Apache-2.0
#include "cli/stats_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>

#include "cli/console.h"
#include "cli/interrupt.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "cli/stats_report.h"
#include "core/error.h"
#include "io/output_file.h"
#include "io/scene_file.h"

namespace twinray {
namespace {

void add_options(CLI::App& app, StatsArguments& arguments, std::vector<int>& resolution) {
  Recording& recording = arguments.options.recording;
  app.add_option("SCENE", arguments.scene, "The scene, a COLLADA file (.dae)")->required()->type_name("");
  add_numbers(app, "-r,--resolution", resolution, 2)
      ->description("Of the picture whose rays are shot (160 120)")
      ->check(CLI::Range(1, 65536))
      ->type_name("W H");
  app.add_option("-s,--samples", recording.samples, "Samples per pixel (1)")
      ->type_name("N")
      ->check(CLI::Range(1u, Film::max_samples));
  const std::function<void(const std::string&)> choose = [&arguments](const std::string& word) {
    arguments.view = word == "file" ? View::file : View::whole;
  };
  app.add_option_function("--view", choose, "As the file's camera sees it, or all of it (whole)")
      ->type_name("file|whole")
      ->check(CLI::IsMember({"file", "whole"}));
  app.add_option("-t,--threads", arguments.options.threads, "Threads (all of the machine)")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  app.add_option("--csv", arguments.csv_file, "Write the figures as a table for other programs")
      ->type_name("FILE");
  app.add_option("--json", arguments.json_file, "Write the figures as JSON")->type_name("FILE");
  app.add_flag("-q,--quiet", arguments.quiet, "No table, no progress, no warnings of the scene");
}

Scene load(const StatsArguments& arguments) {
  LoadedScene loaded = load_scene(arguments.scene);
  if (!arguments.quiet)
    for (const Diagnostic& warning : loaded.warnings) console::warn(warning.text());
  Scene& scene = loaded.scene;
  const Recording& recording = arguments.options.recording;
  if (arguments.view == View::whole)
    scene.camera =
        view_whole(fit_frame(scene.camera, recording.width, recording.height), scene.geometry->bounds());
  return std::move(scene);
}

std::vector<std::string> output_files(const StatsArguments& arguments) {
  std::vector<std::string> files;
  for (const std::string& file : {arguments.csv_file, arguments.json_file})
    if (!file.empty()) files.push_back(file);
  return files;
}

}  // namespace

std::string stats_usage_line() {
  return "usage: twinray stats SCENE.dae [options]; all options: twinray stats --help";
}

std::optional<StatsArguments> parse_stats_arguments(const std::vector<std::string>& words) {
  StatsArguments arguments;
  Recording& recording = arguments.options.recording;
  std::vector<int> resolution{recording.width, recording.height};
  CLI::App app(
      "Builds every engine and split method over a scene and shoots the rays of its paths, recorded once,\n"
      "through each: build time, tree, and what camera, shadow and bounce rays take.",
      "twinray stats");
  app.formatter(std::make_shared<BriefFormatter>());
  app.option_defaults()->take_last()->always_capture_default(false);
  add_options(app, arguments, resolution);
  app.set_help_flag("-h,--help", "Print this help");
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // CLI11 wants the last one first
  } catch (const CLI::CallForHelp&) {
    console::write(app.help());
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
  recording.width = resolution[0];
  recording.height = resolution[1];
  return arguments;
}

int stats_command(const std::vector<std::string>& words) {
  const std::optional<StatsArguments> arguments = parse_stats_arguments(words);
  if (!arguments) return 0;
  const InterruptGuard guard(output_files(*arguments));
  for (const std::string& file : output_files(*arguments)) check_output(file);
  const Scene scene = load(*arguments);
  ProgressLine line(!arguments->quiet);
  const SceneFigures figures =
      measure_engines(scene, arguments->options, [&](const std::string& doing) { line.show(doing); });
  line.finish();
  if (!arguments->csv_file.empty()) write_text_file(arguments->csv_file, stats_csv(figures));
  if (!arguments->json_file.empty()) write_text_file(arguments->json_file, stats_json(*arguments, figures));
  if (!arguments->quiet) console::write(stats_text(*arguments, figures));
  return 0;
}

}  // namespace twinray

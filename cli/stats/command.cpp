// SPDX-License-Identifier: Apache-2.0
#include "cli/stats/command.h"

#include <fmt/format.h>

#include <memory>

#include "cli/console.h"
#include "cli/interrupt.h"
#include "cli/options/options.h"
#include "cli/outputs.h"
#include "cli/progress.h"
#include "cli/resources.h"
#include "cli/statistics_report.h"
#include "core/error.h"
#include "io/output_file.h"
#include "io/scene_file.h"

namespace twinray {
namespace {

void add_options(CLI::App& app, StatsArguments& arguments) {
  Recording& recording = arguments.options.recording;
  add_scene(app, arguments.scene);
  OptionGroup group(app, "Options");
  add_resolution(group, recording.width, recording.height, "Of the picture whose rays are shot");
  group.add_number({"-s,--samples", "N", "Samples per pixel"}, recording.samples, sample_counts);
  add_view(group, arguments.view);
  add_threads(group, arguments.options.threads);
  group.add_number({"--seconds", "T", "Shoot the rays of a kind again until so long has passed"},
                   arguments.options.least_seconds, Range<double>{0, 86400});
  group.add_word({"--csv", "FILE", "Write the statistics as a table for other programs"}, arguments.csv_file);
  group.add_word({"--json", "FILE", "Write the statistics as JSON"}, arguments.json_file);
  group.add_flag("-q,--quiet", arguments.quiet, "No table, no progress");
}

Scene load(const StatsArguments& arguments) {
  Scene scene = load_with_warnings(arguments.scene).scene;
  const Recording& recording = arguments.options.recording;
  scene.camera = camera_of(scene, arguments.view, recording.width, recording.height);
  return scene;
}

std::vector<std::string> output_files(const StatsArguments& arguments) {
  return given_names({arguments.csv_file, arguments.json_file});
}

}  // namespace

std::function<StatsArguments()> add_stats_options(CLI::App& app) {
  const auto arguments = std::make_shared<StatsArguments>();
  add_options(app, *arguments);
  return [arguments] { return *arguments; };
}

int stats_command(const StatsArguments& arguments) {
  check_memory(memory_needs(arguments.options.recording));
  const InterruptGuard guard(output_files(arguments));
  prepare_outputs(output_files(arguments), {arguments.scene});
  if (const std::string fewer = thread_warning(arguments.options.threads); !fewer.empty())
    console::warn(fewer);
  const Scene scene = load(arguments);
  ProgressLine line = progress_line(!arguments.quiet);
  const SceneStatistics statistics =
      measure_engines(scene, arguments.options, [&](const std::string& doing) { line.show(doing); });
  line.finish();
  if (!arguments.csv_file.empty()) write_file(arguments.csv_file, stats_csv(statistics));
  if (!arguments.json_file.empty()) write_file(arguments.json_file, stats_json(arguments, statistics));
  if (!arguments.quiet) console::write(stats_text(arguments, statistics));
  return 0;
}

}  // namespace twinray

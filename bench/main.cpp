// SPDX-License-Identifier: Apache-2.0
// The benchmark program: scene by scene, every engine; then the reports.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "bench/machine.h"
#include "bench/options.h"
#include "bench/reports.h"
#include "core/error.h"
#include "integrators/render.h"
#include "io/destination.h"
#include "io/output_file.h"
#include "io/picture/image_file.h"
#include "io/progress_line.h"

namespace twinray::bench {
namespace {

/// A stream that cannot be written does not end a long run; main asks for its state.
void print(std::FILE* stream, const std::string& text) {
  std::fputs(text.c_str(), stream);
  std::fflush(stream);
}

void write_picture(const SceneSource& source, const PictureOrder& order) {
  check_image_name(order.file);
  check_outputs({order.file});
  const Scene scene = source.make();
  const auto accelerator = build_accelerator(default_backend(), scene.geometry);
  const PathIntegrator path(scene, {});
  const RenderResult result = render(scene, *accelerator, path, {.samples = order.samples});
  write_image(order.file, mean_image(result.film));
}

bool is_sound(const SceneStatistics& scene) {
  for (const EngineStatistics& engine : scene.engines)
    if (!engine.complaint.empty()) return false;
  return true;
}

std::vector<std::string> report_files(const Options& options) {
  std::vector<std::string> files;
  for (const std::string& file : {options.json_file, options.csv_file, options.html_file})
    if (!file.empty()) files.push_back(file);
  return files;
}

/// A file can be written again; what is written into (a pipe, standard output) gets the last reports alone.
void write_reports(const Options& options, const Results& results, bool is_last) {
  const auto write = [&](const std::string& name, std::string (*report)(const Results&)) {
    if (name.empty()) return;
    if (is_last || destination_of(name).kind == Destination::Kind::file) write_file(name, report(results));
  };
  write(options.json_file, json_report);
  write(options.csv_file, csv_report);
  write(options.html_file, html_report);
}

/// Growth is a matter of rays; pictures are made of the scenes that are looked at.
bool is_rendered(const SceneSource& source) { return source.family.empty() || source.name == source.family; }

/// Is told what is being done.
using Report = std::function<void(const std::string&)>;

void measure_whole(const Workload& workload, const Options& options, const Report& report, Results& results) {
  report("whole pictures");
  results.pictures.push_back(measure_pictures(workload, options.whole));
  if (workload.source().name != "box" && workload.source().name != "room") return;
  report("threads and processes");
  for (ScalingStatistics& scaling : measure_scaling(workload, options.whole))
    results.scalings.push_back(std::move(scaling));
  if (workload.source().name != "box") return;
  report("error over time");
  results.errors = measure_error(workload, options.whole);
}

int measure(const Options& options) {
  const std::vector<std::string> files = report_files(options);
  check_outputs(files);
  const bool is_output_taken = std::any_of(files.begin(), files.end(), is_standard_output);
  Results results{
      describe_machine(), options.trace.rounds.count, options.width, options.height, {}, {}, {}, {}, {}};
  const std::vector<SceneSource> sources = choose_scenes(options.scenes);
  ProgressLine line(isatty(STDERR_FILENO) != 0, [](const std::string& text) { print(stderr, text); });
  bool all_sound = true;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const Report report = [&](const std::string& doing) {
      line.show(fmt::format("scene {} of {}: {} | {} | {}", i + 1, sources.size(), sources[i].name, doing,
                            duration_text(line.elapsed_seconds())));
    };
    report("recording its rays");
    Workload workload(sources[i], options.width, options.height);
    results.scenes.push_back(measure_scene(workload, options.trace, report));
    const bool has_file = !sources[i].file.empty();
    if (has_file) {
      report("reading its file");
      results.readings.push_back(measure_reading(workload, options.trace.rounds));
    }
    all_sound = all_sound && is_sound(results.scenes.back());
    const bool has_picture = options.has_renders && is_rendered(sources[i]);
    if (has_picture) measure_whole(workload, options, report, results);
    line.finish();
    // Whoever stops a long run keeps what there is.
    write_reports(options, results, i + 1 == sources.size());
    print(is_output_taken ? stderr : stdout,
          fmt::format("{}{}{}\n", text_report(results.scenes.back()),
                      has_file ? text_report(results.readings.back()) : "",
                      has_picture ? text_report(results.pictures.back()) : ""));
  }
  return all_sound ? 0 : 1;
}

int serve(const Options& options) {
  for (const SceneSource& source : choose_scenes(options.scenes))
    if (source.name == options.worker[0]) serve_renders(source, options.worker[1], options.whole);
  return 0;
}

int run(const std::vector<std::string>& words) {
  const std::optional<Options> options = parse_options(words);
  if (!options) return 0;
  if (!options->worker.empty()) return serve(*options);
  if (options->write_ups) {
    print(stdout, write_up_table(*options->write_ups, [](const std::string& doing) {
            if (isatty(STDERR_FILENO)) print(stderr, doing + "\n");
          }));
    return 0;
  }
  if (!options->picture) return measure(*options);
  const std::vector<SceneSource> sources = choose_scenes(options->scenes);
  if (sources.size() != 1) throw UsageError("--picture wants one scene: name it by --only='^name$'");
  write_picture(sources.front(), *options->picture);
  return 0;
}

}  // namespace
}  // namespace twinray::bench

namespace {

int run(int argc, char** argv) {
  try {
    return twinray::bench::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    twinray::bench::print(stderr, fmt::format("twinray_bench: {}\n", error.what()));
    return dynamic_cast<const twinray::UsageError*>(&error) ? 2 : 1;
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int code = run(argc, argv);
  return code == 0 && (std::ferror(stdout) || std::ferror(stderr)) ? 1 : code;
}

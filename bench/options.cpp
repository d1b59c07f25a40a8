// SPDX-License-Identifier: Apache-2.0
#include "bench/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>
#include <utility>

#include "bench/engines.h"
#include "bench/pattern.h"
#include "core/error.h"
#include "io/generated/generated.h"

namespace twinray::bench {
namespace {

/// "1e4,30000" -> 10000, 30000.
std::vector<std::size_t> parse_sizes(const std::string& list) {
  std::vector<std::size_t> sizes;
  for (const char *at = list.data(), *const end = at + list.size(); at < end;) {
    double size = 0;
    const auto [next, error] = std::from_chars(at, end, size);
    if (error != std::errc{} || !(size >= 1 && size <= double(generated::most_triangles)) ||
        size != std::floor(size) || (next != end && *next != ','))
      throw UsageError(
          fmt::format("--sizes={}: numbers of triangles such as 1e4,1e5,1000000 are wanted, up to {}", list,
                      generated::most_triangles));
    sizes.push_back(std::size_t(std::llround(size)));
    at = next == end ? end : next + 1;
  }
  return sizes;
}

/// Throws UsageError where a pattern names no engine.
void check_engines(const std::string& pattern) {
  const Pattern wanted(pattern);
  std::string names;
  for (const Engine& engine : engines()) {
    if (wanted.matches(engine.name)) return;
    names += (names.empty() ? "" : ", ") + engine.name;
  }
  throw UsageError(fmt::format("--engines={}: no engine has such a name; there are {}", pattern, names));
}

/// How thorough a run is.
struct Effort {
  int rounds;
  double least_seconds;
  int build_rounds;
  int width, height;
  std::size_t divisor;  ///< Of the generated scenes' sizes.
  const char* sizes;
  int render_rounds;
  std::uint32_t most_samples;
};
constexpr Effort usual{7, 0.03, 3, 288, 216, 1, "1e4,1e5,1e6", 5, 64};
constexpr Effort quick{3, 0.002, 1, 96, 72, 10, "1e4,3e4,1e5", 2, 16};
constexpr Effort full{15, 0.1, 5, 384, 288, 1, "1e4,3e4,1e5,3e5,1e6,3e6,1e7", 11, 512};

constexpr std::uint32_t usual_picture_samples = 16;

struct Words {
  bool is_quick = false, is_full = false, has_no_renders = false, are_write_ups = false;
  int repetitions = 0;
  std::string sizes, picture;
  std::optional<std::uint32_t> samples;
};

void add_options(CLI::App& app, Options& options, Words& words) {
  app.add_option("FILE", options.scenes.files, "Scene files to measure besides (.dae)")->type_name("");
  app.add_option("--scenes", options.scenes.folder, "Folder of the well-known scenes")->type_name("DIR");
  app.add_option("--only", options.scenes.only, "Only scenes whose name matches one of these expressions")
      ->type_name("REGEX...");
  app.add_option("--engines", options.trace.engine_pattern,
                 "Only engines whose name matches, and the baseline")
      ->type_name("REGEX");
  app.add_option("--sizes", words.sizes,
                 fmt::format("Triangles of the generated scenes that show growth ({})", usual.sizes))
      ->type_name("N,...");
  app.add_option("--repetitions", words.repetitions, fmt::format("Rounds ({})", usual.rounds))
      ->type_name("N")
      ->check(CLI::Range(1, 1000));
  app.add_flag("--quick", words.is_quick, "A minute or two: smaller scenes, fewer rays and rounds");
  app.add_flag("--full", words.is_full, "Every scene of the folder, every engine, 10^7 triangles; hours");
  app.add_flag("--no-renders", words.has_no_renders, "Only single rays: no whole pictures");
  app.add_flag("--write-ups", words.are_write_ups,
               "Instead: the command lines of CS184's write-ups, as a table; with --quick without long ones");
  app.add_option("--json", options.json_file, "Write everything that was measured")->type_name("FILE");
  app.add_option("--csv", options.csv_file, "Write a table, one line for each scene, engine and ray set")
      ->type_name("FILE");
  app.add_option("--html", options.html_file, "Write one page with tables and plots")->type_name("FILE");
  app.add_option("--picture", words.picture, "Render the one scene of --only instead of measuring")
      ->type_name("FILE");
  app.add_option("--samples", words.samples,
                 fmt::format("Of the picture, per pixel ({})", usual_picture_samples))
      ->type_name("N")
      ->check(CLI::Range(1, 1 << 20));
  app.add_option("--worker", options.worker, "For the program itself")->expected(2)->group("");
  app.set_help_flag("-h,--help", "Print this help");
}

void check(const Words& words, const Options& options) {
  if (words.is_quick && words.is_full) throw UsageError("--quick and --full exclude each other");
  if (words.samples && words.picture.empty()) throw UsageError("--samples goes with --picture");
  const std::pair<const char*, bool> of_rays[] = {
      {"--json", !options.json_file.empty()}, {"--csv", !options.csv_file.empty()},
      {"--html", !options.html_file.empty()}, {"--engines", !options.trace.engine_pattern.empty()},
      {"--sizes", !words.sizes.empty()},      {"--no-renders", words.has_no_renders},
      {"--picture", !words.picture.empty()}};
  for (const auto& [option, is_given] : of_rays)
    if (words.are_write_ups && is_given)
      throw UsageError(fmt::format("{} does not go with --write-ups", option));
  check_engines(options.trace.engine_pattern);
}

void apply(const Words& words, Options& options) {
  check(words, options);
  const Effort& effort = words.is_quick ? quick : words.is_full ? full : usual;
  options.trace.rounds.count = words.repetitions > 0 ? words.repetitions : effort.rounds;
  options.trace.rounds.least_seconds = effort.least_seconds;
  options.trace.most_build_rounds = effort.build_rounds;
  options.trace.is_full = options.scenes.is_full = words.is_full;
  options.width = effort.width;
  options.height = effort.height;
  options.scenes.size_divisor = effort.divisor;
  options.scenes.sizes = parse_sizes(words.sizes.empty() ? effort.sizes : words.sizes);
  options.whole.width = effort.width;
  options.whole.height = effort.height;
  options.whole.rounds = std::min(effort.render_rounds, options.trace.rounds.count);
  options.whole.most_samples = effort.most_samples;
  options.has_renders = !words.has_no_renders;
  if (words.are_write_ups)
    options.write_ups = WriteUpOptions{options.scenes.folder, words.repetitions > 0 ? words.repetitions : 3,
                                       words.is_quick, options.scenes.only};
  if (!words.picture.empty())
    options.picture = PictureOrder{words.picture, words.samples.value_or(usual_picture_samples)};
}

}  // namespace

std::optional<Options> parse_options(const std::vector<std::string>& arguments) {
  Options options;
  options.scenes.own_scenes = TWINRAY_OWN_SCENES;
  options.scenes.folder = TWINRAY_SCENES;
  Words words;
  CLI::App app(
      "Times every engine on rays recorded from the program's own paths, each checked before, and all by "
      "turns.\n"
      "Speeds are ratios to Embree with its own triangles, robust.",
      "run bench");
  app.option_defaults()->always_capture_default(false);
  add_options(app, options, words);
  try {
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());  // CLI11 wants the last first
    // "--scenes=" is no folder; CLI11 would take the next word.
    if (std::erase(reversed, "--scenes=") > 0) options.scenes.folder.clear();
    app.parse(reversed);
  } catch (const CLI::CallForHelp&) {
    fmt::print("{}", app.help());
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
  apply(words, options);
  options.whole.worker_command = {"/proc/self/exe"};
  options.whole.worker_command.insert(options.whole.worker_command.end(), arguments.begin(), arguments.end());
  options.whole.worker_command.push_back("--worker");
  return options;
}

}  // namespace twinray::bench

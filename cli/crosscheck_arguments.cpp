// SPDX-License-Identifier: Apache-2.0
#include "cli/crosscheck_arguments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <limits>

#include "cli/console.h"
#include "cli/options.h"
#include "cli/ray_text.h"
#include "core/error.h"

namespace twinray {
namespace {

std::vector<std::string> parse_engines(const std::string& text) {
  std::vector<std::string> engines;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    engines.push_back(named_engine(text.substr(begin, end - begin)).name);
    begin = end + 1;
  }
  return engines;
}

struct RawArguments {
  std::string engines = fmt::format("{}", fmt::join(default_crosscheck_engines(), ","));
  std::string ray, placement = "file";
};

void add_options(CLI::App& app, CrosscheckArguments& arguments, RawArguments& raw) {
  CrosscheckOptions& options = arguments.options;
  app.add_option("SCENE", arguments.scene, "The scene, a COLLADA file (.dae)")->required()->type_name("");
  app.add_option("--engines", raw.engines, fmt::format("Two or more ({})", raw.engines))
      ->type_name("A,B,...");
  app.add_option("--rays", options.rays, "Of all classes together (1000000)")
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t(1), std::uint64_t(1000000000000)));
  app.add_option("--seed", options.seed, "Another seed, other rays (0)")->type_name("N");
  app.add_option("-t,--threads", options.threads, "Threads (all of the machine)")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  app.add_option("--findings", options.kept, "Print up to N rays an engine and class (10)")
      ->type_name("N")
      ->check(CLI::Range(std::size_t(0), std::size_t(100000)));
  app.add_option("--ray", raw.ray, "Shoot this ray alone and say everything about it")->type_name("RAY");
  app.add_option("--placement", raw.placement, "Of --ray: file, moved, shrunk or grown (file)")
      ->type_name("PLACE");
  app.add_flag("--keep-both-lamps", arguments.load.keep_both_lamps,
               "Keep a lamp's rectangle beside its mesh");
  app.add_flag("--json", arguments.json, "Print JSON instead of the table");
  app.add_flag("-q,--quiet", arguments.quiet, "No progress, no warnings of the scene");
}

}  // namespace

std::string crosscheck_usage_line() {
  return "usage: twinray crosscheck SCENE.dae [options]; all options: twinray crosscheck --help";
}

std::optional<CrosscheckArguments> parse_crosscheck_arguments(const std::vector<std::string>& words) {
  CrosscheckArguments arguments;
  RawArguments raw;
  CLI::App app("Shoots the same rays through several engines and judges every difference.",
               "twinray crosscheck");
  app.formatter(std::make_shared<BriefFormatter>());
  app.option_defaults()->take_last()->always_capture_default(false);
  add_options(app, arguments, raw);
  app.set_help_flag("-h,--help", "Print this help");
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // CLI11 wants the last one first
    arguments.options.engines = parse_engines(raw.engines);
    arguments.placement = parse_placement(raw.placement);
  } catch (const CLI::CallForHelp&) {
    console::write(app.help());
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  } catch (const Error& error) {
    throw UsageError(error.what());
  }
  if (!raw.ray.empty()) arguments.ray = parse_ray(raw.ray);
  arguments.options.build.threads = arguments.options.threads;
  return arguments;
}

}  // namespace twinray

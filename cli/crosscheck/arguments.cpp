// SPDX-License-Identifier: Apache-2.0
#include "cli/crosscheck/arguments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "cli/console.h"
#include "cli/crosscheck/ray_text.h"
#include "cli/options/options.h"
#include "core/error.h"

namespace twinray {
namespace {

std::vector<std::string> parse_engines(const std::string& text) {
  std::vector<std::string> engines;
  bool has_reference = false;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const Engine engine = named_engine(text.substr(begin, end - begin));
    const std::string& name = engine.name;
    has_reference |= can_be_reference(engine);
    if (std::find(engines.begin(), engines.end(), name) != engines.end())
      throw Error(fmt::format("{} stands there twice; an engine says nothing about itself", name));
    engines.push_back(name);
    begin = end + 1;
  }
  if (engines.size() < 2 || !has_reference) throw Error("two are needed, one of them bvh, bvh-2 or embree");
  return engines;
}

/// The options as they are read.
struct CrosscheckRequest {
  CrosscheckArguments arguments;
  std::string engines = fmt::format("{}", fmt::join(default_crosscheck_engines(), ","));
  std::string ray;
  bool ceilings = false;
};

constexpr Range<std::uint64_t> ray_counts{1, 1000000000000};
constexpr Range<std::size_t> finding_counts{0, 100000};
const Choices<Placement> placements{{"file", Placement::file},
                                    {"moved", Placement::moved},
                                    {"shrunk", Placement::shrunk},
                                    {"grown", Placement::grown}};

void add_options(CLI::App& app, CrosscheckRequest& request) {
  CrosscheckArguments& arguments = request.arguments;
  CrosscheckOptions& options = arguments.options;
  add_scene(app, arguments.scene);
  OptionGroup group(app, "Options");
  group.add_word({"--engines", "A,B,...", fmt::format("Two or more ({})", request.engines)}, request.engines);
  group.add_number({"--rays", "N", "Of all classes together"}, options.rays, ray_counts);
  group.add_number({"--seed", "N", "Another seed, other rays"}, options.seed, seeds);
  add_threads(group, options.threads);
  group.add_number({"--findings", "N", "Print up to N rays an engine and class"}, options.kept,
                   finding_counts);
  group.add_word({"--ray", "RAY", "Shoot this ray alone and say everything about it"}, request.ray);
  group.add_choice("--placement", arguments.placement, placements, "Of the scene, for --ray");
  add_instances(group, arguments.load);
  group.add_flag("--keep-both-lamps", arguments.load.keep_both_lamps,
                 "Keep a lamp's rectangle beside its mesh");
  group.add_flag("--ceilings", request.ceilings,
                 "Embree's own triangles, too, fail beyond what they may leak");
  group.add_flag("--json", arguments.json, "Print JSON instead of the table");
  group.add_flag("-q,--quiet", arguments.quiet, "No progress");
}

CrosscheckArguments resolved(const CrosscheckRequest& request) {
  CrosscheckArguments arguments = request.arguments;
  try {
    arguments.options.engines = parse_engines(request.engines);
  } catch (const Error& error) {
    throw UsageError(fmt::format("--engines: {}", error.what()));
  }
  if (request.ceilings) arguments.ceilings = Ceilings::count;
  if (!request.ray.empty()) arguments.ray = parse_ray(request.ray);
  arguments.options.build.threads = arguments.options.threads;
  return arguments;
}

/// Of one ray all is said; of many, nothing is placed.
void warn_of_no_effect(const Words& given, bool is_one_ray) {
  for (const std::string& option : given) {
    if (is_one_ray && (option == "--json" || option == "--rays" || option == "--seed" ||
                       option == "--findings" || option == "--ceilings"))
      console::warn(option + ": no effect, for --ray shoots one ray");
    if (!is_one_ray && option == "--placement")
      console::warn("--placement: no effect, for it goes with --ray");
  }
}

}  // namespace

std::function<CrosscheckArguments()> add_crosscheck_options(CLI::App& app) {
  const auto request = std::make_shared<CrosscheckRequest>();
  add_options(app, *request);
  return [request, &app] {
    CrosscheckArguments arguments = resolved(*request);
    warn_of_no_effect(given_options(app), arguments.ray.has_value());
    return arguments;
  };
}

}  // namespace twinray

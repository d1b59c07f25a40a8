// SPDX-License-Identifier: Apache-2.0
#include "cli/render_options.h"

namespace twinray {
namespace {

constexpr const char* group_name = "Run";

}  // namespace

void add_run_options(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, group_name);
  RenderArguments& arguments = request.arguments;
  add_threads(group, arguments.render.threads);
  group.add_flag("--count", arguments.render.counting, "Count nodes and primitives per ray (slower)");
  add_run_words(app, request);
  group.add_flag("-q,--quiet", arguments.quiet, "Print errors and warnings only");
}

void add_run_words(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, group_name);
  RenderArguments& arguments = request.arguments;
  group.add_word({"--stats", "FILE", "Write all statistics as JSON"}, arguments.stats_file);
  group.add_flag("--strict", arguments.load.strict,
                 "What a scene file or an option says must have an effect");
}

}  // namespace twinray

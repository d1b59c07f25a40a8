// SPDX-License-Identifier: Apache-2.0
#include "cli/live/web_server.h"
#include "cli/options/common.h"
#include "cli/options/render.h"
#include "io/network/tev_viewer.h"

namespace twinray {
namespace {

/// None for the empty text.
std::optional<NetworkAddress> parsed(const char* option, const std::string& text,
                                     NetworkAddress (*parse)(const std::string&)) {
  if (text.empty()) return std::nullopt;
  try {
    return parse(text);
  } catch (const Error& error) {
    throw UsageError(fmt::format("{}: {}", option, error.what()));
  }
}

}  // namespace

void add_run_options(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, option_groups::run);
  RenderArguments& arguments = request.arguments;
  add_threads(group, arguments.render.threads);
  group.add_flag("--count", arguments.render.counting, "Count nodes and primitives per ray (slower)");
  add_run_words(app, request);
  const std::string usual = text_of(parse_server_address(""));
  group.add_optional_word(
      {"--serve", "[=HOST:PORT]", fmt::format("Show the growing picture in browsers ({})", usual)}, usual,
      request.serve);
  group.add_choice<ProgressKind>(
      "--progress", arguments.progress,
      {{"line", ProgressKind::line}, {"json", ProgressKind::json}, {"none", ProgressKind::none}},
      "On standard error; json: an object each second");
  group.add_word({"--metrics-file", "FILE", "Keep its progress there, for Prometheus"},
                 arguments.metrics_file);
  add_sandbox(group, "Read the folder of the scene and these, write outputs", request.sandbox);
  add_limits(group, "Interrupt it after so many seconds, of loading, too", arguments.limits);
  group.add_flag("-q,--quiet", arguments.quiet, "Print errors and warnings only");
}

void add_run_words(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, option_groups::run);
  RenderArguments& arguments = request.arguments;
  group.add_word({"--stats", "FILE", "Write all statistics as JSON"}, arguments.stats_file);
  const std::string usual = text_of(parse_viewer_address(""));
  group.add_optional_word(
      {"--tev", "[=HOST:PORT]", fmt::format("Show the growing picture in tev ({})", usual)}, usual,
      request.tev);
  group.add_flag("--strict", arguments.load.strict,
                 "What a scene file or an option says must have an effect");
}

void resolve_run(const RenderRequest& request, RenderArguments& arguments) {
  arguments.viewer = parsed("--tev", request.tev, parse_viewer_address);
  arguments.server = parsed("--serve", request.serve, parse_server_address);
  arguments.sandbox = sandbox_places(request.sandbox);
  if (arguments.sandbox && arguments.convert_textures)
    throw UsageError(
        "--sandbox: --convert-textures writes beside the scene's pictures, which it does not allow");
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "cli/live/web_server.h"
#include "cli/render_options.h"
#include "cli/sandbox/sandbox.h"
#include "io/tev_viewer.h"

namespace twinray {
namespace {

constexpr const char* group_name = "Run";
constexpr Range<double> memory_megabytes{64, 1e9};
constexpr Range<double> time_limits{1e-3, 1e9};
constexpr const char* no_places = ":";

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
  OptionGroup group(app, group_name);
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
  group.add_optional_word(
      {"--sandbox", "[=PLACE:...]", "Read the folder of the scene and these, write outputs"}, no_places,
      request.sandbox);
  group.add_words({"--memory", "MB", "Of the process, at most (all there is)"}, 1,
                  [&arguments](const Words& words) {
                    const double megabytes = parse_number("--memory", words.front(), memory_megabytes);
                    arguments.memory_bytes = std::uint64_t(1e6 * megabytes);
                  });
  group.add_number({"--time-limit", "T", "Interrupt it after so many seconds, of loading, too"},
                   arguments.time_limit, time_limits);
  group.add_flag("-q,--quiet", arguments.quiet, "Print errors and warnings only");
}

void add_run_words(CLI::App& app, RenderRequest& request) {
  OptionGroup group(app, group_name);
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
  if (request.sandbox.empty()) return;
  arguments.sandbox = places_in(request.sandbox);
  if (arguments.convert_textures)
    throw UsageError(
        "--sandbox: --convert-textures writes beside the scene's pictures, which it does not allow");
}

}  // namespace twinray

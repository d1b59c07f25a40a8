// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "cli/render_arguments.h"
#include "cli/stats.h"

namespace twinray {

/// What a stats command line asks for.
struct StatsArguments {
  std::string scene;
  View view = View::whole;
  StatsOptions options;
  std::string csv_file, json_file;  ///< Empty: none.
  bool quiet = false;
};

/// Reads the words after "stats". None: the help was printed, and that is all. Throws UsageError with the
/// reason.
std::optional<StatsArguments> parse_stats_arguments(const std::vector<std::string>& words);

/// One line: how the command is called.
std::string stats_usage_line();

/// twinray stats SCENE [options]: builds every engine, shoots the rays of the scene's own paths through it,
/// and prints a table. Returns the exit code, 0. Throws Error.
int stats_command(const std::vector<std::string>& words);

}  // namespace twinray

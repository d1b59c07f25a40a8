// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <string>

#include "cli/common_options.h"
#include "cli/engine_statistics.h"

namespace twinray {

/// What a stats command line asks for.
struct StatsArguments {
  std::string scene;
  View view = View::whole;
  StatsOptions options;
  std::string csv_file, json_file;  ///< Empty: none.
  bool quiet = false;
};

/// Adds the command's options; the function that is returned gives what they ask for, once they are read.
std::function<StatsArguments()> add_stats_options(CLI::App& app);

/// twinray stats SCENE [options]: builds every engine, shoots the rays of the scene's own paths through it,
/// and prints a table. Returns the exit code, 0. Throws Error.
int stats_command(const StatsArguments& arguments);

}  // namespace twinray

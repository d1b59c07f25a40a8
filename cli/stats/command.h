// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>

#include "cli/stats/arguments.h"

namespace twinray {

/// Adds the command's options; the function that is returned gives what they ask for, once they are read.
std::function<StatsArguments()> add_stats_options(CLI::App& app);

/// twinray stats SCENE [options]: builds every engine, shoots the rays of the scene's own paths through it,
/// and prints a table. Returns the exit code, 0. Throws Error.
int stats_command(const StatsArguments& arguments);

}  // namespace twinray

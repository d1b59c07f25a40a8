// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "cli/stats.h"
#include "cli/stats_command.h"

namespace twinray {

/// One line an engine, and what the figures were measured with; "-" stands for what an engine does not tell.
std::string stats_text(const StatsArguments& arguments, const SceneFigures& figures);

/// One line for each engine and kind of rays, after a line of names; what is not known is left empty.
std::string stats_csv(const SceneFigures& figures);

/// The same as JSON; what is not known is null.
std::string stats_json(const StatsArguments& arguments, const SceneFigures& figures);

}  // namespace twinray

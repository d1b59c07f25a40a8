// SPDX-License-Identifier: Apache-2.0
// The command line of CS184's program: letters with its meanings and defaults, and the options of ours that
// have no letter.
#pragma once
#include <string>

#include "cli/options/options.h"
#include "cli/render_arguments.h"

namespace twinray {

/// What the words after the program's name ask for; `output` is empty where they name no picture. Throws
/// UsageError in the words of the letters, and CLI11's CallForHelp and CallForVersion.
RenderArguments parse_cs184_arguments(const Words& words);

/// The usage text of CS184's program, with what it leaves out. `path` is how the program was called.
std::string cs184_usage(const std::string& path);

}  // namespace twinray

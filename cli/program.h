// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

namespace twinray {

/// Runs the subcommand that the first of the words after the program's name names; render where it names
/// none. Returns the exit code. Throws UsageError, with the subcommand's usage line below the reason, and
/// Error.
int run_program(std::vector<std::string> words);

}  // namespace twinray

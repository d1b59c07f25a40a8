// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <string>

#include "cli/options/options.h"

namespace CLI {
class App;
}  // namespace CLI

namespace twinray {

/// Adds the file, which the function that is returned gives; all other words are left to resume_command().
std::function<std::string()> add_resume_options(CLI::App& app);

/// twinray resume FILE [option of render]...: renders on from a checkpoint or another film that is not done,
/// by the options that it was begun with; those among the words, which begin with the file, count more.
/// Returns the exit code. Throws Error, and UsageError.
int resume_command(const std::string& file, const Words& words);

}  // namespace twinray

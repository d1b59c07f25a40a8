// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "cli/options/options.h"
#include "cli/relight/relight.h"

namespace twinray {

/// "key=0.5" or "key=1,0.8,0.6" -> what becomes of a light group. Throws UsageError.
LightChange parse_light_change(const std::string& text);

/// What a relight command line asks for.
struct RelightArguments {
  std::string picture;  ///< A file.
  std::vector<LightChange> changes;
  std::string output;  ///< Empty: the groups are listed, and nothing is written.
  bool quiet = false;
};

/// Adds the command's options; the function that is returned gives what they ask for, once they are read.
std::function<RelightArguments()> add_relight_options(CLI::App& app);

/// twinray relight FILE.exr [options]: mixes a picture's light groups anew, or lists them. Returns the exit
/// code. Throws Error.
int relight_command(const RelightArguments& arguments, const Words& words);

}  // namespace twinray

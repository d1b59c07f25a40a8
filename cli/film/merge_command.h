// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <string>

#include "cli/options/options.h"

namespace twinray {

/// What a merge's command line asks for.
struct MergeArguments {
  Words films;
  std::string output;
  bool allow_gaps = false;
  int threads = 0;
  bool quiet = false;
};

/// Adds the options; the function that is returned gives what they ask for. It throws UsageError.
std::function<MergeArguments()> add_merge_options(CLI::App& app);

/// twinray merge FILM... -o OUT: one picture, or one film, of the films of its parts. Returns the exit code.
/// Throws Error.
int merge_command(const MergeArguments& arguments);

}  // namespace twinray

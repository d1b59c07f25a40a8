// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "cli/compare/comparison.h"
#include "cli/options/options.h"

namespace twinray {

/// What a measure may be at most.
struct CompareLimit {
  compare::Measure measure = compare::Measure::mse;
  double most = 0;
};

/// "0.001" (of the mean squared error) or "flip:0.05" -> a limit. Throws UsageError.
CompareLimit parse_limit(const std::string& text);

/// What a compare command line asks for.
struct CompareArguments {
  std::string picture, reference;  ///< Files.
  std::vector<CompareLimit> limits;
  std::string html_file;  ///< Empty: none.
  bool quiet = false;
};

/// Adds the command's options; the function that is returned gives what they ask for, once they are read.
std::function<CompareArguments()> add_compare_options(CLI::App& app);

/// twinray compare PICTURE REFERENCE [options]: how two pictures differ. Returns the exit code: 1 where a
/// measure exceeds a limit, else 0. Throws Error for pictures that cannot be compared.
int compare_command(const CompareArguments& arguments, const Words& words);

}  // namespace twinray

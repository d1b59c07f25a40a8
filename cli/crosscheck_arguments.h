// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "check/scene_crosscheck.h"
#include "io/scene_file.h"

namespace twinray {

/// What a crosscheck command line asks for.
struct CrosscheckArguments {
  std::string scene;
  LoadOptions load;
  CrosscheckOptions options;
  std::optional<Ray> ray;  ///< Only this one is shot, and everything about it said.
  Placement placement = Placement::file;
  bool json = false;
  bool quiet = false;
};

/// Reads the words after "crosscheck". None: the help was printed, and that is all. Throws UsageError with
/// the reason.
std::optional<CrosscheckArguments> parse_crosscheck_arguments(const std::vector<std::string>& words);

/// One line: how the command is called.
std::string crosscheck_usage_line();

}  // namespace twinray

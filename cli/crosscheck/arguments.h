// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "check/scene_crosscheck.h"
#include "cli/crosscheck/report.h"
#include "cli/options/common.h"
#include "io/scene_file.h"

namespace twinray {

/// What a crosscheck command line asks for.
struct CrosscheckArguments {
  std::string scene;
  LoadOptions load;
  CrosscheckOptions options;
  std::optional<Ray> ray;  ///< Only this one is shot, and everything about it said.
  Placement placement = Placement::file;
  Ceilings ceilings = Ceilings::remark;
  bool json = false;
  bool quiet = false;
};

/// Adds the command's options; the function that is returned gives what they ask for, once they are read.
std::function<CrosscheckArguments()> add_crosscheck_options(CLI::App& app);

}  // namespace twinray

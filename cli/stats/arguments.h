// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "cli/options/common.h"
#include "cli/stats/engine_statistics.h"

namespace twinray {

/// What a stats command line asks for.
struct StatsArguments {
  std::string scene;
  View view = View::whole;
  StatsOptions options;
  std::string csv_file, json_file;  ///< Empty: none.
  bool quiet = false;
};

}  // namespace twinray

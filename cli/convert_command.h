// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <string>

#include "cli/common_options.h"
#include "cli/environment_options.h"
#include "io/exchange.h"

namespace twinray {

/// What a convert command line asks for.
struct ConvertArguments {
  std::string scene;
  std::string output;       ///< The JSON file.
  std::string environment;  ///< Empty: none.
  EnvironmentPlacement placement;
  LoadOptions load;
  View view = View::file;
  ExchangeFrame frame;
  bool quiet = false;
};

/// Adds the command's options; the function that is returned gives what they ask for, once they are read.
std::function<ConvertArguments()> add_convert_options(CLI::App& app);

/// twinray convert SCENE OUT.json [options]: writes the scene in the exchange form (io/exchange.h). Returns
/// the exit code, 0. Throws Error.
int convert_command(const ConvertArguments& arguments);

}  // namespace twinray

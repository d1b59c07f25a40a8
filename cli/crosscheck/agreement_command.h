// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "cli/crosscheck/agreement.h"
#include "cli/options/common.h"

namespace twinray {

/// What an agreement command line asks for.
struct AgreementArguments {
  std::vector<std::string> scenes;  ///< Empty: our own, and the well-known ones where they are.
  AgreementOptions options;
  std::vector<View> views{View::file, View::whole};  ///< Each scene is compared in each of them.
  bool quiet = false;
};

/// Adds the command's options; the function that is returned gives what they ask for, once they are read.
std::function<AgreementArguments()> add_agreement_options(CLI::App& app);

/// twinray agreement [SCENE...] [options]: compares all engines on each scene and prints a table. Returns the
/// exit code: 0 if all pictures have the same bits, else 1. Throws Error.
int agreement_command(const AgreementArguments& arguments);

}  // namespace twinray

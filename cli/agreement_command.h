// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "cli/agreement.h"
#include "cli/render_arguments.h"

namespace twinray {

/// What an agreement command line asks for.
struct AgreementArguments {
  std::vector<std::string> scenes;  ///< Empty: our own, and the well-known ones where they are.
  AgreementOptions options;
  std::vector<View> views{View::file, View::whole};  ///< Each scene is compared in each of them.
  bool quiet = false;
};

/// Reads the words after "agreement". None: the help was printed, and that is all. Throws UsageError with the
/// reason.
std::optional<AgreementArguments> parse_agreement_arguments(const std::vector<std::string>& words);

/// One line: how the command is called.
std::string agreement_usage_line();

/// twinray agreement [SCENE...] [options]: compares all engines on each scene and prints a table. Returns the
/// exit code: 0 if all pictures have the same bits, else 1. Throws Error.
int agreement_command(const std::vector<std::string>& words);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "cli/crosscheck/arguments.h"

namespace twinray {

/// twinray crosscheck SCENE [options]: shoots the same rays through several engines and prints how their
/// answers differ. Returns the exit code: 0 if nothing is unexplained (and, with --ceilings, no ceiling
/// passed), else 1. Throws Error.
int crosscheck_command(const CrosscheckArguments& arguments);

}  // namespace twinray

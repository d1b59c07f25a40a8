// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "cli/options/options.h"

namespace twinray {

/// Renders as CS184's program does, by its options, with its printed lines (docs/cs184.md). `path` is how the
/// program was called, for its usage text. Returns the exit code. Throws UsageError, after it has printed the
/// usage text, and Error.
int run_cs184(const std::string& path, const Words& words);

}  // namespace twinray

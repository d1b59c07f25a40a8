// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "cli/render_arguments.h"

namespace twinray {

/// Prints the path of the sample that `arguments.replay` asks for, and writes it to the files asked for;
/// renders nothing. Returns the exit code: 1 where the integrator's sample has other bits than the path.
/// Throws Error, and UsageError for a sample that the picture does not have.
int replay_command(const RenderArguments& arguments);

}  // namespace twinray

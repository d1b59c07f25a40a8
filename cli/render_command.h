// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "cli/render_arguments.h"

namespace twinray {

/// twinray [render] SCENE [options]: loads, builds, renders, writes; the picture remembers the words that it
/// was asked for with. Returns the exit code: 0, but 1 where engines were checked and differ as they may not.
/// Throws Error.
int render_command(const RenderArguments& arguments, const std::vector<std::string>& words);

}  // namespace twinray

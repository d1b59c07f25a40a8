// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "cli/render_arguments.h"
#include "cli/render_talk.h"

namespace twinray {

/// twinray [render] SCENE [options]: loads, builds, renders, writes; the picture remembers the words that it
/// was asked for with, and `talk` is told of each step. Returns the exit code: 0, but 1 where engines were
/// checked and differ as they may not. Throws Error.
int render_command(const RenderArguments& arguments, const std::vector<std::string>& words, RenderTalk& talk);
/// With the standard talk, or none if the arguments say so.
int render_command(const RenderArguments& arguments, const std::vector<std::string>& words);

}  // namespace twinray

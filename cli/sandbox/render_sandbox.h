// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "cli/render_arguments.h"
#include "cli/sandbox/sandbox.h"

namespace twinray {

/// What a render needs: to read the scene's folder and files that the command line names, to write into the
/// folders of its outputs, and no network but for a viewer or a server that is asked for. Throws Error for
/// places that do not exist.
SandboxNeeds needs_of_render(const RenderArguments& arguments, const std::vector<std::string>& outputs);

}  // namespace twinray

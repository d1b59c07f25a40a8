// SPDX-License-Identifier: Apache-2.0
// What a render may do that is not trusted: its scene may be from anybody.
#pragma once
#include <string>
#include <vector>

#include "cli/render_arguments.h"
#include "cli/render_outputs.h"

namespace twinray {

/// The places of a list, as PATH has them: "a:b"; empty ones are none.
std::vector<std::string> places_in(const std::string& list);

/// Leaves to the process what the render needs: to read the scene's folder, files that the command line names
/// and the system's libraries, to write into the folders of its outputs, and no network but for a viewer or
/// a server that is asked for. Throws Error where the process has another
/// thread. Returns what was closed, in a
/// line. What the kernel cannot close is a warning, under --strict an Error.
std::string enter_sandbox(const RenderArguments& arguments, const std::vector<std::string>& outputs);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "cli/options/common.h"
#include "cli/options/environment.h"
#include "io/render_defaults.h"

namespace twinray {

/// What a convert command line asks for.
struct ConvertArguments {
  std::string scene;
  std::string output;       ///< The file that others go beside.
  std::string environment;  ///< Empty: none.
  EnvironmentPlacement placement;
  LoadOptions load;
  View view = View::file;
  std::optional<RenderDefaults::Resolution> resolution;  ///< None: the scene file's.
  bool quiet = false;
};

/// Adds the command's options; the function that is returned gives what they ask for, once they are read.
std::function<ConvertArguments()> add_convert_options(CLI::App& app);

/// twinray convert SCENE OUT [options]: writes the scene in the form that the ending of OUT says
/// (io/scene_writer.h), and warns of what that cannot say. Returns the exit code, 0. Throws Error.
int convert_command(const ConvertArguments& arguments);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "cli/options/common.h"
#include "io/render_defaults.h"

namespace twinray {

/// What an info command line asks for.
struct InfoArguments {
  std::string scene;
  LoadOptions load;
  /// Of the picture whose memory is told; none: the scene file's, or render's.
  std::optional<RenderDefaults::Resolution> resolution;
  bool json = false;
};

/// Adds the command's options; the function that is returned gives what they ask for, once they are read.
std::function<InfoArguments()> add_info_options(CLI::App& app);

/// twinray info SCENE [options]: what is in a scene, and what memory a render of it takes. Returns the exit
/// code, 0. Throws Error.
int info_command(const InfoArguments& arguments);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Private: STL files as scenes.
#pragma once
#include <string>

#include "io/load_options.h"
#include "io/loaded_scene.h"

namespace twinray {

/// A scene of the solids of an STL file, grey. Throws Error as read_stl() does.
LoadedScene load_stl(const std::string& path, const LoadOptions& options = {});

}  // namespace twinray

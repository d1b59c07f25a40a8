// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "io/load_options.h"
#include "io/loaded_scene.h"

namespace twinray {

/// A scene of the one mesh of a PLY file, grey. Throws Error as read_ply() does.
LoadedScene load_ply(const std::string& path, const LoadOptions& options = {});

}  // namespace twinray

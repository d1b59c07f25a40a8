// SPDX-License-Identifier: Apache-2.0
// Scenes of pbrt-v4 (M. Pharr, W. Jakob, G. Humphreys, "Physically Based Rendering", 4th edition, 2023). What
// the reader makes of each statement: docs/pbrt.md.
#pragma once
#include <string>

#include "io/load_options.h"
#include "io/loaded_scene.h"
#include "io/pbrt/files.h"

namespace twinray {

/// Reads the text of a scene file, which may name others; `name` stands for it in messages, and says where
/// the others lie. Throws Error with file, line and column.
LoadedScene read_pbrt(std::string text, const std::string& name, const LoadOptions& options = {},
                      PbrtFiles::Read read = {});

/// The same of a file on disk, packed by gzip or not.
LoadedScene load_pbrt(const std::string& path, const LoadOptions& options = {});

}  // namespace twinray

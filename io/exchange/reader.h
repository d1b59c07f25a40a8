// SPDX-License-Identifier: Apache-2.0
// Scenes in exchange form, as io/exchange/writer.h writes them.
#pragma once
#include <functional>
#include <string>

#include "io/load_options.h"
#include "io/loaded_scene.h"

namespace twinray {

/// Reads the JSON file of this path and the files that it names, which lie beside it. What is rendered of it
/// has the bits of the scene that was written (docs/exchange.md). Throws Error, with the entry and what would
/// be valid; a picture of a texture that cannot be used is warned of, and magenta.
LoadedScene load_exchange(const std::string& path, const LoadOptions& options = {});

/// Gives the bytes of a file; throws Error.
using ExchangeRead = std::function<std::string(const std::string& path)>;
/// The same of the text of such a file, and of meshes and pictures of lights that are read by `read`, from
/// several threads.
LoadedScene read_exchange(const std::string& json, const std::string& path, const LoadOptions& options,
                          const ExchangeRead& read);

}  // namespace twinray

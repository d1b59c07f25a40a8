// SPDX-License-Identifier: Apache-2.0
// Private: the textures of a file of the exchange form.
#pragma once
#include <string>
#include <vector>

#include "core/texture.h"
#include "io/diagnostic.h"
#include "io/exchange/entry.h"
#include "io/load_options.h"

namespace twinray {

/// Those that the file of this path lists, with the pictures that lie beside it; each is read once. A picture
/// that cannot be used is shown magenta, with a warning. Throws Error for what is wrong in the file itself.
std::vector<Texture> read_textures(const Entry& file, const std::string& path, const LoadOptions& options,
                                   WarningList& warnings);

}  // namespace twinray

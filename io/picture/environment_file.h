// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "core/image.h"

namespace twinray {

/// A latitude-longitude picture as core/environment.h takes it.
struct LoadedEnvironment {
  Image map;          ///< Every component lies in [0, max_radiance].
  std::string fault;  ///< Pixels that were not radiance, and have become black: how many, and the first one.
                      ///< Empty where there are none.
  std::string warning = {};  ///< What else is to be told of the file; or empty.
};

/// Reads a picture of radiance; io/picture/image_file.h says which files are valid. Throws Error.
LoadedEnvironment load_environment(const std::string& path);

}  // namespace twinray

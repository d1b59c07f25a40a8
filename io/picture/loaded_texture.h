// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <string>

#include "core/mip_map.h"

namespace twinray {

/// A picture for core/texture.h.
struct LoadedTexture {
  std::shared_ptr<const MipMap> image;  ///< Never null; one magenta pixel where the file cannot be used.
  std::string warning;  ///< What is wrong with the file, and what is shown instead. Empty where nothing is.
  bool is_stand_in = false;  ///< The file cannot be used at all.
};

}  // namespace twinray

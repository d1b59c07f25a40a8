// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <string>

#include "core/mip_map.h"
#include "io/image_file.h"

namespace twinray {

/// A picture for core/texture.h.
struct LoadedTexture {
  std::shared_ptr<const MipMap> image;  ///< Never null; one magenta pixel where the file cannot be used.
  std::string warning;  ///< What is wrong with the file, and what is shown instead. Empty where nothing is.
};

/// Reads a picture of up to 2^26 pixels (with its mip-map, a gigabyte); a larger one is refused before memory
/// is taken for it. Never throws for what is wrong with the file: a scene is shown without one of its
/// pictures, in a colour that is not overlooked. Numbers that are not finite become 0.
LoadedTexture load_texture(const std::string& path, PictureRole role,
                           PictureChannels channels = PictureChannels::color);

/// Reads a normal map, whose numbers are data; flat where the file cannot be used, which a warning says.
LoadedTexture load_normal_map(const std::string& path);

}  // namespace twinray

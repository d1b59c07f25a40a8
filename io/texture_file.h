// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <string>

#include "core/mip_map.h"
#include "io/image_file.h"
#include "io/texture_store.h"

namespace twinray {

/// What a texture makes of a picture's numbers.
struct PictureMeaning {
  PictureRole role = PictureRole::color;
  PictureChannels channels = PictureChannels::color;
};

/// A picture for core/texture.h.
struct LoadedTexture {
  std::shared_ptr<const MipMap> image;  ///< Never null; one magenta pixel where the file cannot be used.
  std::string warning;  ///< What is wrong with the file, and what is shown instead. Empty where nothing is.
};

/// Reads a picture of up to 2^26 pixels (with its mip-map, a gigabyte); a larger one is refused before memory
/// is taken for it. Never throws for what is wrong with the file: a scene is shown without one of its
/// pictures, in a colour that is not overlooked. Numbers that are not finite become 0. The store, if there is
/// one, keeps it; throws Error where it cannot.
LoadedTexture load_texture(const std::string& path, const PictureMeaning& meaning,
                           TextureStore* store = nullptr);

/// Reads a normal map, whose numbers are data; flat where the file cannot be used, which a warning says.
LoadedTexture load_normal_map(const std::string& path, TextureStore* store = nullptr);

}  // namespace twinray

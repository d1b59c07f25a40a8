// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

#include "io/load_options.h"
#include "io/picture/image_file.h"
#include "io/picture/loaded_texture.h"

namespace twinray {

/// Reads a picture of up to 2^26 pixels (with its mip-map, a gigabyte); a larger one is refused before memory
/// is taken for it. Where convert_texture made a file of it that is not older, that one is taken; so is one
/// that is named itself. Never throws for what is wrong with the file: a scene is shown without one of its
/// pictures, in a colour that is not overlooked. Numbers that are not finite become 0. The store of the
/// options, if there is one, keeps it; throws Error where it cannot. If they only want to know of pictures,
/// it is one pixel.
LoadedTexture load_texture(const std::string& path, const PictureMeaning& meaning,
                           const LoadOptions& options = {});

/// The same of a PNG or JPEG picture whose bytes stand in another file; `name` says the format, and stands
/// for it in the warning. It has no tiles.
LoadedTexture decode_texture(std::string_view bytes, const std::string& name, const PictureMeaning& meaning,
                             const LoadOptions& options = {});

/// What stands for a picture that cannot be had, and why.
LoadedTexture missing_texture(const std::string& fault);

/// Reads a normal map, whose numbers are data; flat where the file cannot be used, which a warning says.
LoadedTexture load_normal_map(const std::string& path, const LoadOptions& options = {});

/// What became of a picture that was to be converted.
struct ConvertedTexture {
  std::string path;    ///< Of the file with its tiles.
  bool is_new = true;  ///< Else it was there, and is not older than the picture.
  int width = 0, height = 0, levels = 0;
  std::string warning;  ///< Of the picture; empty where nothing is wrong.
};

/// Writes a picture with its mip-map beside it (io/picture/tiled_texture.h), unless that is there. Throws
/// Error where it cannot be read or written.
ConvertedTexture convert_texture(const PictureUse& picture);

}  // namespace twinray

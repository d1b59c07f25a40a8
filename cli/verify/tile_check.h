// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "cli/render_arguments.h"
#include "cli/verify/picture_channels.h"
#include "cli/verify/scratch_folder.h"
#include "io/loaded_scene.h"

namespace twinray {

/// So many different tiles of 16 x 16 pixels of the picture's window, chosen by the seed; all if there are no
/// more.
std::vector<PixelRect> chosen_tiles(const PixelRect& window, std::uint32_t count, std::uint64_t seed);

/// A tile whose pixels are not those of the picture.
struct WrongTile {
  PixelRect tile;
  PixelDifferences pixels;
};

/// A picture that is read.
struct ClaimedPicture {
  const StoredLayers& layers;
  bool is_denoised = false;  ///< Its noisy channels are compared.
};

/// Renders these tiles, and writes each as the picture is written, to a file in the folder, to read it again:
/// so that every way of encoding is that of the picture. Throws Error.
std::vector<WrongTile> check_tiles(const ClaimedPicture& picture, const RenderArguments& arguments,
                                   const LoadedScene& loaded, const std::vector<PixelRect>& tiles,
                                   const ScratchFolder& folder);

}  // namespace twinray

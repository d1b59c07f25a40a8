// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <optional>
#include <string>

#include "core/film.h"
#include "io/picture/layered_image.h"

namespace twinray {

/// All channels of a picture that is read: those of an EXR, else R, G, B and A, which is 1 where the file has
/// none. Throws Error.
StoredLayers read_picture(const std::string& path);

/// How pixels of a picture differ from those of a part of it that was made again.
struct PixelDifferences {
  std::size_t pixels = 0;            ///< Which differ.
  int x = 0, y = 0;                  ///< The first of them, in the picture.
  std::string channel;               ///< The first of its channels that differs,
  std::optional<float> there, here;  ///< Its values; nothing where one has no such channel.
};

/// Compares the bits of all channels; `place` says which pixels of the picture the part shows. A
/// channel that one of them does not have differs in each pixel. Of a denoised picture the noisy channels are
/// compared, in place of those that were made of them.
std::optional<PixelDifferences> differences(const StoredLayers& picture, const StoredLayers& part,
                                            const PixelRect& place, bool is_denoised);

}  // namespace twinray

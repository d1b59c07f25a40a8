// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>

#include "core/film.h"
#include "core/image.h"

namespace twinray {

/// Some pixels of a frame.
struct FramePart {
  PixelRect window;
  int width = 0, height = 0;  ///< Of the frame.
  friend bool operator==(const FramePart&, const FramePart&) = default;
};

/// What a picture, read from a file, says that it shows; nothing where that is the whole frame, or the file
/// does not say: others may have cut it out.
std::optional<FramePart> part_shown(const std::string& path, const Image& image);

/// "x 5 to 25, y 0 to 15 of 40 x 30 pixels".
std::string frame_part_text(const FramePart& part);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// What a picture's file has beside the pixels.
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace twinray {

/// Names and values.
using ImageMetadata = std::vector<std::pair<std::string, std::string>>;

/// The whole frame of which a picture is a part, and where its left top pixel lies in it.
struct ImageFrame {
  int x = 0, y = 0;
  int width = 0, height = 0;  ///< 0: the picture is the whole frame.
};

}  // namespace twinray

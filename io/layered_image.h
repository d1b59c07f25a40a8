// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace twinray {

/// One channel of a picture of layers. Its name says which layer it belongs to, as OpenEXR has it: "N.X".
struct PictureChannel {
  std::string name;
  bool is_half = false;  ///< Stored in 16 bits, else in 32.
};

/// A picture of any channels. It is asked for its rows from the top on, so that it need not be in memory as a
/// whole.
struct LayeredImage {
  int width = 0, height = 0;
  std::vector<PictureChannel> channels;
  /// Fills row y with the values of all channels of its first pixel, of its second, and so on.
  std::function<void(int y, std::span<float> values)> fill_row;
};

}  // namespace twinray

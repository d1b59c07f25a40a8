// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "io/picture/image_metadata.h"

namespace twinray {

/// One channel of a picture of layers. Its name says which layer it belongs to, as OpenEXR has it: "N.X".
struct PictureChannel {
  std::string name;
  bool is_half = false;  ///< Stored in 16 bits, else in 32.
};

/// How an OpenEXR picture is packed.
enum class ExrCompression {
  zip,   ///< Without any loss.
  dwab,  ///< Colours lose what is hardly seen; other channels nothing, but what is named like a colour.
};

/// A picture of any channels. It is asked for its rows from the top on, so that it need not be in memory as a
/// whole.
struct LayeredImage {
  int width = 0, height = 0;
  std::vector<PictureChannel> channels;
  /// Fills row y with the values of all channels of its first pixel, of its second, and so on.
  std::function<void(int y, std::span<float> values)> fill_row;
  ExrCompression compression = ExrCompression::zip;
};

/// What an OpenEXR picture holds.
struct StoredLayers {
  int width = 0, height = 0;
  std::vector<PictureChannel> channels;
  std::vector<float> values;  ///< Of all channels of its first pixel, of its second, and so on.
  ImageMetadata metadata;
  ImageFrame frame;
};

}  // namespace twinray

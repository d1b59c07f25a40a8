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
  dwab,  ///< Channels named like a colour's lose what is hardly seen in one: see is_lossy().
};

/// Whether `dwab` changes the numbers of a channel: by the last part of its name (R, G, B, Y, RY or BY).
bool is_lossy(const std::string& channel);

/// A picture of any channels. It is asked for its rows from the top on, so that it need not be in memory as a
/// whole.
struct LayeredImage {
  int width = 0, height = 0;
  std::vector<PictureChannel> channels;
  /// Fills row y with the values of all channels of its first pixel, of its second, and so on.
  std::function<void(int y, std::span<float> values)> fill_row;
  ExrCompression compression = ExrCompression::zip;
};

/// Whether `dwab` can hold all numbers of the channels that it changes: those up to 65504.
bool fits_dwab(const LayeredImage& image);

/// What an OpenEXR picture holds.
struct StoredLayers {
  int width = 0, height = 0;
  std::vector<PictureChannel> channels;
  std::vector<float> values;  ///< Of all channels of its first pixel, of its second, and so on.
  ImageMetadata metadata;
  ImageFrame frame;
};

}  // namespace twinray

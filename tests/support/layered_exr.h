// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace twinray::test {

/// The values of each channel, row by row: one for each pixel, or one for each two by two.
using Channels = std::map<std::string, std::vector<float>>;

/// What such a file's header says beside its size.
struct ExrHeader {
  int frame_x = 0, frame_y = 0;  ///< Of the frame's left top pixel,
  int x = 0, y = 0;              ///< and of the picture's, which has the frame's size.
  std::map<std::string, std::string> texts = {};
};

/// The bytes of an OpenEXR file of 32-bit floats, not compressed ("OpenEXR File Layout").
std::string layered_exr(int width, int height, const Channels& channels, const ExrHeader& stated = {});

/// The bytes of an OpenEXR file of several parts, each of one grey pixel and a name.
std::string exr_of_parts(const std::vector<std::pair<std::string, float>>& parts);

}  // namespace twinray::test

// SPDX-License-Identifier: Apache-2.0
#include "io/picture/layered_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace twinray {

bool is_lossy(const std::string& channel) {
  constexpr std::array<std::string_view, 6> endings{"R", "G", "B", "Y", "RY", "BY"};
  const std::string_view last = std::string_view(channel).substr(channel.rfind('.') + 1);
  return std::find(endings.begin(), endings.end(), last) != endings.end();
}

bool fits_dwab(const LayeredImage& image) {
  constexpr float largest = 65504;  // Of halves, in which it computes.
  const std::size_t channels = image.channels.size();
  std::vector<bool> lossy;
  for (const PictureChannel& channel : image.channels) lossy.push_back(is_lossy(channel.name));
  std::vector<float> row(std::size_t(image.width) * channels);
  for (int y = 0; y < image.height; ++y) {
    image.fill_row(y, row);
    for (std::size_t i = 0; i < row.size(); ++i)
      if (lossy[i % channels] && std::fabs(row[i]) > largest) return false;
  }
  return true;
}

}  // namespace twinray

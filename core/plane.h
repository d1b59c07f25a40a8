// SPDX-License-Identifier: Apache-2.0
// One number for each pixel of a picture, and filters over its neighbours.
#pragma once
#include <cstddef>
#include <vector>

namespace twinray {

/// Row by row from the top left.
struct Plane {
  int width = 0, height = 0;
  std::vector<float> values;

  Plane() = default;
  Plane(int w, int h) : width(w), height(h), values(std::size_t(w) * std::size_t(h)) {}
  float* row(int y) { return values.data() + std::size_t(y) * std::size_t(width); }
  const float* row(int y) const { return values.data() + std::size_t(y) * std::size_t(width); }
};

/// The weights of the pixels from -r to r beside the one in the middle: an odd number of them.
using Kernel = std::vector<float>;

/// Each number becomes the weighted sum of its neighbours: `across` in its row, then `down` in its column.
/// Beyond the border the pixels of the border go on.
Plane filtered(const Plane& plane, const Kernel& across, const Kernel& down);

}  // namespace twinray

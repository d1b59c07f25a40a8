// SPDX-License-Identifier: Apache-2.0
#include "integrators/denoise/patch_distance.h"

namespace twinray {
namespace {

constexpr int wide = tile_width + 2 * patch_radius, high = tile_height + 2 * patch_radius;
/// Where there is no noise at all, pixels that differ are far apart, and equal ones are not.
constexpr float least_variance = 1e-20f;

/// Of a row of pixels, summed up over the channels.
void add_differences(const Guide& guide, int x, int y, Step step, std::array<float, wide>& sums) {
  sums.fill(0);
  for (std::size_t c = 0; c < guide.color.size(); ++c) {
    const float* const own = guide.color[c].at(x, y);
    const float* const other = guide.color[c].at(x + step.x, y + step.y);
    const float* const own_variance = guide.variance[c].at(x, y);
    const float* const other_variance = guide.variance[c].at(x + step.x, y + step.y);
    for (std::size_t i = 0; i < wide; ++i) {
      const float difference = own[i] - other[i];
      const float noise = own_variance[i] + std::min(own_variance[i], other_variance[i]);
      sums[i] += (difference * difference - noise) / (least_variance + own_variance[i] + other_variance[i]);
    }
  }
}

}  // namespace

void patch_distances(const Guide& guide, int x0, int y0, Step step, TilePlane& distances) {
  constexpr int side = 2 * patch_radius + 1;
  const float share = 1.0f / float(side * side * int(guide.color.size()));
  std::array<std::array<float, tile_width>, high> rows{};
  for (int y = 0; y < high; ++y) {
    std::array<float, wide> differences;
    add_differences(guide, x0 - patch_radius, y0 - patch_radius + y, step, differences);
    std::array<float, tile_width>& row = rows[std::size_t(y)];
    for (std::size_t k = 0; k < side; ++k)
      for (std::size_t x = 0; x < tile_width; ++x) row[x] += differences[x + k];
  }
  for (std::size_t y = 0; y < tile_height; ++y) {
    std::array<float, tile_width> sums{};
    for (std::size_t k = 0; k < side; ++k)
      for (std::size_t x = 0; x < tile_width; ++x) sums[x] += rows[y + k][x];
    for (std::size_t x = 0; x < tile_width; ++x) distances[y][x] = std::max(0.0f, sums[x] * share);
  }
}

}  // namespace twinray

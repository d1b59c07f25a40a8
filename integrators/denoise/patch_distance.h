// SPDX-License-Identifier: Apache-2.0
// Private: how different two pixels look, by all that is around them.
#pragma once
#include <span>

#include "integrators/denoise/tile.h"

namespace twinray {

/// A picture that says which pixels are alike, with the variance of its pixels, channel by channel.
struct Guide {
  std::vector<PaddedPlane> color, variance;
};

/// For each pixel of the tile at x0, y0: the mean squared difference of the patches around it and around its
/// neighbour, in units of its variance, less what noise alone makes of it (Rousselle et al. 2012, equation 3,
/// with k = 1); 0 at least.
void patch_distances(const Guide& guide, int x0, int y0, Step step, TilePlane& distances);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "core/film.h"

namespace twinray {

/// Cuts a window into tiles of up to size x size pixels, ordered in a spiral from its middle outward: what a
/// viewer looks at first is done first. Each pixel lies in exactly one tile.
std::vector<PixelRect> spiral_tiles(const PixelRect& window, int size);

}  // namespace twinray

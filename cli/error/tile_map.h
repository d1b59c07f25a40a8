// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "check/bias.h"

namespace twinray::error {

/// The tiles of a picture as SVG: red where it is brighter than the reference, blue where darker, and the
/// more so the less likely noise would make it; a tile that a test of all tiles together rejects has a
/// border.
std::string tile_map(const BiasTest& test);

/// A tile's colour, "#rrggbb": white where the means agree.
std::string tile_color(const WelchTest& test);

}  // namespace twinray::error

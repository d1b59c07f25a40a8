// SPDX-License-Identifier: Apache-2.0
// Private: means over squares of pixels.
#pragma once
#include "core/plane.h"

namespace twinray {

/// Of the pixels up to `radius` away in each direction, those that are within the plane. filtered() takes
/// those of the border for what is beyond it: their noise would count several times.
Plane box_mean(const Plane& plane, int radius);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/light.h"

namespace twinray {

/// A picture of all directions in the other layout, MapLayout::equal_area: a square about as fine as the
/// picture is in its middle rows, and of 64 pixels a side at least. Each pixel is the mean of sixteen
/// directions.
Image equal_area_of(const Image& map, MapLayout layout);

/// The radiance of a hemisphere around +z, and black below, in that layout. Its mean is exact.
Image hemisphere(const Rgb& radiance);

}  // namespace twinray

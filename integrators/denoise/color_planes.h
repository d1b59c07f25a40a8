// SPDX-License-Identifier: Apache-2.0
// A picture's colours, channel by channel.
#pragma once
#include <array>
#include <span>

#include "core/image.h"
#include "core/plane.h"

namespace twinray {

/// Red, green and blue.
using Color = std::array<Plane, 3>;

/// As a picture.
Image image_of(std::span<const Plane> color);
Color color_of(const Image& image);

}  // namespace twinray

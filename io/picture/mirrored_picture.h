// SPDX-License-Identifier: Apache-2.0
// Pictures that go on beside themselves as their mirror images: one of twice the size that repeats.
#pragma once
#include "core/image.h"
#include "core/texture.h"

namespace twinray {

/// The picture, and beside and below it its mirror images, where they are wanted.
Image mirrored(const Image& image, bool to_right, bool below);

/// Of coordinates in such a picture: half of those in the picture, from its upper left corner.
UvTransform halved(const UvTransform& uv, bool to_right, bool below);

}  // namespace twinray

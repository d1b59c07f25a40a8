// SPDX-License-Identifier: Apache-2.0
// Differences as pictures.
#pragma once
#include "check/flip.h"
#include "core/image.h"

namespace twinray::compare {

/// From dark violet (0) to light yellow (1).
ByteImage flip_picture(const FlipMap& map);
/// The colours of that scale from 0 to 1, a row of pixels.
ByteImage flip_scale();

/// The difference of luminance that has the full colour in a signed picture: 99 of 100 pixels differ less.
double full_difference(const Image& picture, const Image& reference);
/// Red where the picture is brighter than the reference, blue where it is darker, white where it is equal.
ByteImage signed_picture(const Image& picture, const Image& reference, double full);

}  // namespace twinray::compare

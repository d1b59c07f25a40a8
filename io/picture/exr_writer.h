// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "core/mip_map.h"
#include "io/picture/layered_image.h"

namespace twinray {

/// The bytes of an OpenEXR file; write_exr says of what.
std::vector<unsigned char> encode_exr(const LayeredImage& image, const ImageMetadata& metadata,
                                      const ImageFrame& frame);

/// The bytes of one in tiles, with channels R, G, B of 32-bit floats and all levels.
std::vector<unsigned char> encode_tiled_exr(const MipMap& map, int side, const ImageMetadata& metadata);

}  // namespace twinray

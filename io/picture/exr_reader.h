// SPDX-License-Identifier: Apache-2.0
// OpenEXR pictures, read by OpenEXR's own library: of a file of several parts the first. Each function throws
// Error where the file cannot be read.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/color_matrix.h"
#include "core/image.h"
#include "io/picture/layered_image.h"
#include "io/picture/picture_header.h"

namespace twinray {

/// R, G and B; without them those of the first layer that has any, else the first three channels, in the
/// order of decode_exr_layers. The first one but the alpha as grey where there are fewer, or where it is
/// luminance. Of luminance with chroma at a lower resolution the colours that it stands for.
Image decode_exr(const PictureBytes& picture, const HeaderCheck& check);
/// What its red, green and blue are; nothing where it does not say so.
std::optional<Primaries> decode_exr_primaries(const PictureBytes& picture, const HeaderCheck& check);
/// The alpha channel as grey, 1 where there is none.
Image decode_exr_alpha(const PictureBytes& picture, const HeaderCheck& check);
/// All channels, by their layers' names; within a layer R, G, B (or r, g, b), X, Y, A and Z first, then the
/// others by name.
StoredLayers decode_exr_layers(const PictureBytes& picture, const HeaderCheck& check);
/// The channel of that name, row by row; empty where there is none.
std::vector<float> decode_exr_channel(const PictureBytes& picture, const std::string& name,
                                      const HeaderCheck& check);
/// Where its pixels lie in their frame.
ImageFrame decode_exr_frame(const PictureBytes& picture, const HeaderCheck& check);
/// The texts beside the pixels.
ImageMetadata decode_exr_metadata(const PictureBytes& picture, const HeaderCheck& check);

}  // namespace twinray

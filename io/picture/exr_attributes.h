// SPDX-License-Identifier: Apache-2.0
// Private: what an OpenEXR file's header says, in our words.
#pragma once
#include <ImfHeader.h>

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/color_matrix.h"
#include "io/picture/image_metadata.h"
#include "io/picture/layered_image.h"

namespace twinray {

/// What stands before the last dot of a channel's name, its layer, and behind it.
std::pair<std::string_view, std::string_view> layer_and_name(std::string_view channel);

/// R, G, B or A for what programs call so: "r", "Red", "ALPHA"; any other name as it is.
std::string_view usual_channel(std::string_view name);

/// The channels by their layers' names; within a layer R, G, B, Y, A and Z first, then the others by name.
std::vector<PictureChannel> channels_of(const Imf::Header& header);

/// The attributes that are texts. That of the time is called "DateTime".
ImageMetadata texts_of(const Imf::Header& header);

ImageFrame frame_of(const Imf::Header& header);

/// What red, green and blue are; nothing where the header does not say it.
std::optional<Primaries> primaries_of(const Imf::Header& header);

/// The header of a picture of this size and place, without channels.
Imf::Header header_of(int width, int height, const ImageMetadata& metadata, const ImageFrame& frame);

}  // namespace twinray

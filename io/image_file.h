// SPDX-License-Identifier: Apache-2.0
// Pictures on disk. The only door to OpenImageIO.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "core/image.h"

namespace twinray {

/// Names and values that are stored in the file beside the pixels.
using ImageMetadata = std::vector<std::pair<std::string, std::string>>;

/// Throws Error unless a picture of this name could be written (check_output): the ending must be .png or
/// .exr.
void check_image_output(const std::string& path);

/// Whether a picture of this name keeps linear floats: its ending is .exr.
bool is_linear_output(const std::string& path);

/// 8-bit PNG; throws Error where it cannot be written. The file is written beside its place and then renamed:
/// an old file of that name survives until the new one is complete.
void write_png(const std::string& path, const ByteImage& image, const ImageMetadata& metadata = {});
/// OpenEXR, channels R, G, B, 32-bit float; otherwise as write_png.
void write_exr(const std::string& path, const Image& image, const ImageMetadata& metadata = {});
/// By the name's ending: EXR keeps the linear values, PNG is sRGB.
void write_image(const std::string& path, const Image& image, const ImageMetadata& metadata = {});

/// Reads an EXR, HDR, PNG or JPEG picture of up to 2^28 pixels as linear colours: the first three channels,
/// or the first one as grey; 8-bit files are taken as sRGB. Throws Error.
Image read_image(const std::string& path);

}  // namespace twinray

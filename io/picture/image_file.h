// SPDX-License-Identifier: Apache-2.0
// Pictures on disk. PNG, EXR and JPEG have their own libraries here; OpenImageIO, which takes long to load,
// reads and writes HDR, and writes JPEG and TIFF.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/image.h"
#include "io/picture/image_metadata.h"
#include "io/picture/layered_image.h"
#include "io/picture/output_format.h"
#include "io/picture/picture_meaning.h"

namespace twinray {

// Pictures go where write_file puts them: whole, or the old file stays. The same arguments give the same
// bytes: no time is stored but that of the metadata's "DateTime", if it has any.

/// 8-bit sRGB PNG (io/picture/png.h); throws Error where it cannot be written.
void write_png(const std::string& path, const ByteImage& image, const ImageMetadata& metadata = {});
/// OpenEXR, channels R, G, B, 32-bit float; the picture is the data window, the frame the display window.
/// Otherwise as write_png.
void write_exr(const std::string& path, const Image& image, const ImageMetadata& metadata = {},
               const ImageFrame& frame = {});
/// The same of any channels.
void write_exr(const std::string& path, const LayeredImage& image, const ImageMetadata& metadata = {},
               const ImageFrame& frame = {});
/// Linear floats in the format of the name (io/picture/output_format.h): EXR as write_exr; TIFF of 32-bit
/// floats; HDR of shared exponents, which keeps no negative values; PFM, which holds no metadata.
void write_linear(const std::string& path, const Image& image, const ImageMetadata& metadata = {},
                  const ImageFrame& frame = {});
/// 8-bit sRGB in the format of the name: PNG, or JPEG of quality 95.
void write_display(const std::string& path, const ByteImage& image, const ImageMetadata& metadata = {});
/// The one or the other, by the name.
void write_image(const std::string& path, const Image& image, const ImageMetadata& metadata = {},
                 const ImageFrame& frame = {});

struct ReadOptions {
  PictureRole role = PictureRole::color;
  PictureChannels channels = PictureChannels::color;
  std::int64_t most_pixels = std::int64_t(1) << 28;  ///< A larger picture is refused before it is read.
};

/// Whether a picture of this name holds radiance, by its ending: EXR, HDR and PFM do; the others hold what a
/// display shows, from 0 to 1. Throws Error where it is none that is read.
bool holds_radiance(const std::string& path);

/// Reads an EXR, HDR, PNG, JPEG, WebP, PFM or TGA picture of up to 2^28 pixels as linear colours, those of
/// its file whatever their alpha; one number a pixel is grey. What the file begins with says the format, else
/// its ending. Throws Error.
Image read_image(const std::string& path, const ReadOptions& options = {});

/// The same of its whole frame, of which an EXR may hold a part, or more: what the file lacks is black.
Image read_framed_image(const std::string& path);

/// All channels of an EXR picture, with its metadata and frame. Throws Error.
StoredLayers read_layers(const std::string& path);

/// A warning where an OpenEXR picture that can be read has several parts, of which all readers take the first
/// one: how many they are, and its name. Else "".
std::string unread_parts(const std::string& path);
/// The same of the bytes of a file.
std::string unread_parts(std::string_view bytes, const std::string& name);

/// The texts beside the pixels of an EXR, HDR, PNG or JPEG picture; none of other formats. Throws Error.
ImageMetadata read_metadata(const std::string& path);

/// Where the pixels of a picture lie in their frame, by an EXR's windows or the metadata of a PNG;
/// nothing where it does not say. Throws Error.
std::optional<ImageFrame> read_frame(const std::string& path);

/// The channel of that name of an EXR picture ("variance.Y"), row by row; empty where the picture has none,
/// or is no EXR. Throws Error.
std::vector<float> read_channel(const std::string& path, const std::string& name);

/// read_image from the bytes of a file; messages begin with the name.
Image decode_image(std::string_view bytes, const std::string& name, const ReadOptions& options = {});

}  // namespace twinray

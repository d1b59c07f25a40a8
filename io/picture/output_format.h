// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

namespace twinray {

/// The formats that pictures are written in.
enum class OutputFormat { png, jpeg, exr, tiff, hdr, pfm };

/// By the ending of the name, in capitals or not: .png; .jpg, .jpeg; .exr; .tif, .tiff; .hdr; .pfm. A picture
/// with any other name is a PNG.
OutputFormat output_format(const std::string& path);

/// Throws Error unless the name of a picture says its format. What is no regular file (standard output, a
/// device, a FIFO) may have any name.
void check_image_name(const std::string& path);

/// Whether a format keeps linear floats; the others hold what a display shows.
inline bool is_linear(OutputFormat format) {
  return format != OutputFormat::png && format != OutputFormat::jpeg;
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <string>

#include "cli/input_files.h"
#include "cli/options/options.h"
#include "io/picture/image_metadata.h"

namespace twinray {

/// What a picture's metadata says of how it was made.
struct PictureClaim {
  std::string program;  ///< Its name and version.
  bool is_cs184 = false;
  Words words;  ///< Of the command line.
  std::uint32_t samples = 1;
  std::string engine;
  InputFiles inputs;
  bool is_denoised = false;
};

/// Throws Error, which begins with the path, where they say nothing, or that it is no picture as the command
/// makes it: it was interrupted, merged with gaps, mixed anew, or shows something else.
PictureClaim read_claim(const std::string& path, const ImageMetadata& metadata);

/// What the command line asks for, with as many samples as the picture has, and nothing written or kept.
/// Throws Error where its words are none of this program's.
RenderArguments arguments_of(const PictureClaim& claim);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// A converged picture on disk: linear colours as EXR, and in a second file, where they are known, its noise.
#pragma once
#include <string>

#include "check/picture_error.h"
#include "cli/frame_part.h"
#include "io/picture/image_metadata.h"

namespace twinray::error {

/// "a/b.exr" -> "a/b_noise.exr": where the noise of a reference is.
std::string noise_name(const std::string& reference);

/// Throws Error unless the name ends in .exr.
void check_reference_name(const std::string& path);

/// Reads the picture, and its noise where that file is there. Throws Error where it cannot be read, has
/// another size, says that it shows another part of a frame, or has a pixel that is not finite.
ConvergedPicture read_reference(const std::string& path, const FramePart& part);

/// Writes both files.
void write_reference(const std::string& path, const ConvergedPicture& converged,
                     const ImageMetadata& metadata, const ImageFrame& frame);

}  // namespace twinray::error

// SPDX-License-Identifier: Apache-2.0
// Whether a picture's metadata agree with one another.
#pragma once
#include <string>

#include "cli/verify/claim.h"
#include "core/geometry.h"

namespace twinray {

/// What stands beside the command line, the scene, the seed, the pixel filter, what biases it and the engine,
/// is what the command line asks for, or the scene's file, which `loaded` knows: the arguments that it was
/// loaded for. Throws Error, which begins with the path, where it is not. The engine may be any where the
/// scene decides about it.
void check_claim(const std::string& path, const ImageMetadata& metadata, const PictureClaim& claim,
                 const RenderArguments& loaded);

/// That the scene decides about the engine, and chooses here another one than the picture says; empty: not
/// so.
std::string engine_doubt(const PictureClaim& claim, const Geometry& geometry);

}  // namespace twinray

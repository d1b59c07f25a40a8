// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "core/image.h"

namespace twinray {

/// Reads a picture that is to be compared with others. Throws Error where it cannot be read, or a pixel is
/// not finite. Warns of parts of the file that are not read.
Image read_finite_image(const std::string& path);

}  // namespace twinray

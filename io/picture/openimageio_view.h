// SPDX-License-Identifier: Apache-2.0
// Private: OpenColorIO, as OpenImageIO brings it along.
#pragma once
#include <string>

#include "core/image.h"

namespace twinray {

/// ImageCodec::viewed.
Image opencolorio_view(const Image& image, const std::string& display, const std::string& view);

}  // namespace twinray

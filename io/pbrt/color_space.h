// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string_view>

#include "core/rgb.h"

namespace twinray {

/// The color spaces that a file may give rgb values in.
enum class PbrtColorSpace { srgb, dci_p3, rec2020, aces2065_1 };

/// By pbrt's name, in capitals or not: "srgb", "dci-p3", "rec2020", "aces2065-1". Nothing for any other.
std::optional<PbrtColorSpace> color_space_named(std::string_view name);

/// The same color by the primaries of sRGB. White stays white: (1, 1, 1). What those primaries cannot give
/// becomes 0 in that component.
Rgb to_srgb(const Rgb& color, PbrtColorSpace space);

}  // namespace twinray

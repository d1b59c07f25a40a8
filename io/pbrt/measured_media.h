// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string_view>
#include <vector>

#include "core/rgb.h"

namespace twinray {

/// What was measured of a medium, per millimeter. Its scattering is the reduced one, of a medium that
/// scatters evenly and looks the same at some depth.
struct MeasuredMedium {
  std::string_view name;
  Rgb scattering, absorption;
};

/// The media that pbrt knows by name; null for others.
const MeasuredMedium* measured_medium(std::string_view name);
/// The names of all.
std::vector<std::string_view> measured_media();

}  // namespace twinray

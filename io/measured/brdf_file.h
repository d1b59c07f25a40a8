// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

#include "core/measured_brdf.h"

namespace twinray {

/// Reads a measured material (.bsdf) of the database of EPFL's Realistic Graphics Lab, of spectra or of
/// colours. A spectrum becomes what it shows under daylight (CIE D65), in sRGB's primaries; what is negative,
/// and a reflectance that is no number, is 0. `name` stands for the file in messages. Throws Error where it
/// is none, or does not fit together.
MeasuredBrdf read_brdf_file(std::string_view bytes, const std::string& name);

/// What such a file says of colours.
enum class BrdfColors {
  rgb,      ///< The three numbers.
  spectra,  ///< Spectra that show them: smooth ones, since the measured ones are not kept. pbrt needs them.
};
std::string brdf_file_bytes(const MeasuredBrdf& brdf, BrdfColors colors);

}  // namespace twinray

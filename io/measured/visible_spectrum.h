// SPDX-License-Identifier: Apache-2.0
// Reflectances over wavelengths and their colors under daylight (CIE D65), in sRGB's primaries.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/rgb.h"

namespace twinray {

/// A reflectance is linear between wavelengths (in nanometers, increasing) and constant beyond them: for each
/// of them, the color that one of 1 there and 0 at the others has. A constant reflectance is that number,
/// thrice.
std::vector<std::array<double, 3>> reflectance_weights(std::span<const float> wavelengths);

/// Spectra of the three primaries: the smoothest of those that are never negative, by least squares of the
/// differences between neighbours. Together they are 1.3 at most.
struct PrimarySpectra {
  std::vector<float> wavelengths;
  std::vector<Rgb> values;  ///< Of red, green and blue.
};
PrimarySpectra primary_spectra();

}  // namespace twinray

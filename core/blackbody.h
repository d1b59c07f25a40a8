// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/rgb.h"

namespace twinray {

/// Planck's law up to a factor that is the same for all; the wavelength in nm.
double planck(double wavelength, double kelvin);

/// What a black body emits, relative to its spectral radiance at the wavelength where that is greatest, which
/// counts as 1: as pbrt-v4 has the temperatures of media. A component that sRGB cannot give is 0. Kelvin;
/// below 500 nothing, and above 10^6 as there. By a table, within 0.1 % of the spectrum's color.
Rgb blackbody_glow(double kelvin);

}  // namespace twinray

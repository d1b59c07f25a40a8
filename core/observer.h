// SPDX-License-Identifier: Apache-2.0
// How spectra look: the curves of the CIE's observer of 1931 (2 degrees) and its daylight, from 360 to 830 nm
// in steps of 5 nm, and the primaries of sRGB.
#pragma once
#include <array>
#include <span>

namespace twinray {

/// What the observer sees of light of one wavelength (in nm), and how much of that daylight (D65) has.
struct Observed {
  double wavelength, x, y, z, daylight;
};
std::span<const Observed> observer();

struct Xyz {
  double x = 0, y = 0, z = 0;
};

/// By the primaries of sRGB (IEC 61966-2-1), linear, not clipped.
std::array<double, 3> to_rgb(const Xyz& c);

}  // namespace twinray

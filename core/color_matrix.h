// SPDX-License-Identifier: Apache-2.0
// Linear maps between colour spaces, in double.
#pragma once
#include <array>

#include "core/rgb.h"

namespace twinray {

using ColorMatrix = std::array<std::array<double, 3>, 3>;

ColorMatrix product(const ColorMatrix& a, const ColorMatrix& b);
/// Of a matrix that has one.
ColorMatrix inverse(const ColorMatrix& m);
std::array<double, 3> transformed(const ColorMatrix& m, const std::array<double, 3>& v);
inline Rgb transformed(const ColorMatrix& m, const Rgb& c) {
  const auto [r, g, b] = transformed(m, std::array<double, 3>{c.r, c.g, c.b});
  return {float(r), float(g), float(b)};
}

/// CIE's x and y.
struct Chromaticity {
  double x, y;
};
struct Primaries {
  Chromaticity red, green, blue, white;
};
/// Of sRGB and Rec. 709, with the white D65: those of all our colours.
inline constexpr Primaries srgb_primaries{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.3127, 0.3290}};

/// From colours by these primaries to CIE's XYZ; (1, 1, 1) is the white, with Y = 1.
ColorMatrix to_xyz(const Primaries& primaries);

/// From XYZ to what the eye's receptors answer, sharpened: Bradford's (Lam, 1985).
inline constexpr ColorMatrix bradford{
    {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};

/// From colours to receptors by `to_cones`, whose answers to one light, `from`, become those to another,
/// `to`.
ColorMatrix adapted(const ColorMatrix& to_cones, const std::array<double, 3>& from,
                    const std::array<double, 3>& to);
/// From linear colours by these primaries to our own; their white becomes ours, by Bradford's adaptation.
ColorMatrix to_srgb(const Primaries& primaries);

}  // namespace twinray

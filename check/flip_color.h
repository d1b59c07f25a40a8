// SPDX-License-Identifier: Apache-2.0
// The colour spaces of FLIP (check/flip.h). All are relative to the white of sRGB, D65.
#pragma once
#include "core/rgb.h"

namespace twinray::flip {

/// YCxCz, linear in radiance: lightness 0 to 100, then red against green, and yellow against blue.
struct Opponent {
  float y = 0, cx = 0, cz = 0;
};
Opponent opponent_of(const Rgb& linear);
Rgb linear_of(const Opponent& color);

/// L*a*b* (CIE 1976) after R. Hunt: the darker, the less colourful.
struct HuntLab {
  float lightness = 0, a = 0, b = 0;
};
/// Channels in [0, 1].
HuntLab hunt_lab_of(const Rgb& linear);

/// HyAB, a distance for large differences, too: the lightness apart from the colour (S. Abasi, M. Amani
/// Tehran and M. D. Fairchild, 2020).
float distance(const HuntLab& a, const HuntLab& b);

/// What is left of a linear colour on a display: channels in [0, 1].
Rgb clipped(const Rgb& linear);

/// A filmic curve (K. Narkowicz, "ACES Filmic Tone Mapping Curve", 2016), of radiance >= 0 to [0, 1].
Rgb tone_mapped(const Rgb& radiance);
/// The radiance for which the curve gives 0.85.
double radiance_of_bright_tone();

}  // namespace twinray::flip

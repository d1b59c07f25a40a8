// SPDX-License-Identifier: Apache-2.0
// A clear film on a surface, so thin that what both of its sides reflect interferes: soap, oil, oxide.
//
// Film and base let light of the wavelength w through as (Airy)
//
//     T(w) = (1 - r1^2) (1 - r2^2) / (1 + q^2 + 2 q cos(2 pi d / w)),   q = r1 r2,
//
// with the amplitudes r1 and r2 that the film's sides reflect (Fresnel) and the detour d of what is reflected
// below. As a series of cosines it is (1 - r1^2) (1 - r2^2) / (1 - q^2) times 1 + 2 sum of (-q)^m
// cos(2 pi m d / w), and of a channel's mean over all wavelengths nothing is left but the mean of each
// cosine: a function of m d alone, which is tabulated (Belcour and Barla 2017 have fits of it).
#pragma once
#include "core/rgb.h"

namespace twinray {

/// What a channel under daylight sees, in the mean, of cos(2 pi detour / wavelength): 1 at 0, and 0 beyond
/// film_coherence. A detour in nm, >= 0. Absolute error below 1e-3.
Rgb mean_interference(float detour);
inline constexpr float film_coherence = 10000;

class ThinFilm {
 public:
  /// Its thickness in nm, >= 0; the indices of refraction of the film, and of what is above it, > 0.
  ThinFilm(float thickness, float ior, float above = 1);

  /// What film and base reflect of unpolarised light from above, whose cosine to the normal is in [0, 1]. One
  /// index of refraction a channel, that of the base to what is above the film, > 0.
  Rgb reflectance(float cosine, const Rgb& base_ior) const;

 private:
  float detour_;  ///< Along the normal.
  float eta_;     ///< Of the film, to what is above.
};

/// The index of refraction, above 1, of which so much light is reflected along the normal; in [0, 1).
Rgb index_of_reflectance(const Rgb& reflectance);

}  // namespace twinray

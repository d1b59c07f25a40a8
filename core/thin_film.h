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
#include "core/fresnel.h"
#include "core/rgb.h"

namespace twinray {

/// What a channel under daylight sees, in the mean, of cos(2 pi detour / wavelength): 1 at 0. A detour
/// in nm, >= 0. Absolute error below 1e-3 up to film_coherence; beyond, where up to 0.014 is left, it is 0.
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

/// A film that covers a part of the boundary between two media.
struct PartialFilm {
  ThinFilm film;
  float weight;           ///< The part, in [0, 1].
  bool is_below = false;  ///< It lies behind the boundary: the viewer is within the base.
  float coat_ior = 1;     ///< Of what light from air goes through before it meets the film, at least 1.

  /// What the boundary reflects: its cosine and index as fresnel_dielectric() has them. None of it absorbs
  /// light, so what goes in reflects as much as what comes out along the same way.
  Rgb reflectance(float cosine, float eta) const;
  /// The cosine with which light meets the film, of its own in air.
  float below_coat(float cosine) const { return coat_ior == 1 ? cosine : refracted_cosine(cosine, coat_ior); }
};

/// The index of refraction, above 1, of which so much light is reflected along the normal; in [0, 1).
Rgb index_of_reflectance(const Rgb& reflectance);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Spectra as colors. Light and matter are rendered in three channels, so a spectrum becomes what pbrt's RGB
// film would see of it: integrals with the curves of the CIE's observer of 1931 (2 degrees), in steps of 1 nm
// from 360 to 830 nm, then by the primaries of sRGB.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/rgb.h"
#include "io/pbrt/files.h"
#include "io/pbrt/parameters.h"

namespace twinray {

/// Values over wavelengths, linear between them and constant beyond; the wavelengths increase.
struct Spectrum {
  std::vector<float> wavelengths;  ///< In nanometers.
  std::vector<float> values;       ///< As many.

  /// Linear between wavelengths, and 0 beyond them, as pbrt has it.
  float at(float wavelength) const;
};

/// The color of light of this spectrum, with luminance 1: pbrt takes the "scale" of a light as its
/// photometric strength. A component that sRGB cannot give is 0. Black where nothing of it can be seen.
Rgb light_color(const Spectrum& spectrum);
/// The color of light of a black body, as pbrt has it: with luminance 1. Kelvin, above 0.
Rgb blackbody_color(double kelvin);
/// The color of daylight of a temperature up to 25000 K, with luminance 1: the CIE's D series (CIE 15) or,
/// below 4000 K, a black body, as pbrt's films take it.
Rgb daylight_color(double kelvin);
/// What a surface of this reflectance shows under daylight (CIE D65): a constant spectrum stays that number.
/// The same weights turn the index of refraction of a metal and its absorption into channels.
Rgb matter_color(const Spectrum& spectrum);
/// The mean under daylight as the eye weighs it: an index of refraction of glass.
float luminous_mean(const Spectrum& spectrum);

/// A spectrum that pbrt knows by a name, such as "metal-Au-eta", "glass-BK7" or "stdillum-D50".
struct NamedSpectrum {
  std::string_view name;
  Rgb color;  ///< As light_color() or matter_color() make it of the measured values, at steps of 1 nm.
};
/// Nothing where no spectrum has this name.
std::optional<NamedSpectrum> named_spectrum(std::string_view name);
std::vector<std::string_view> named_spectra();

/// Reads pairs of wavelength and value, as an .spd file holds them, "#" before comments.
Spectrum parse_spectrum(const PbrtFile& file);

/// What a color is for: it decides which values are valid and how spectra become one.
enum class ColorRole {
  reflectance,  ///< In [0, 1].
  unbounded,    ///< Indices of refraction, absorption: at least 0.
  light
};

/// The color that a parameter gives: of type rgb, spectrum or blackbody; of type float a grey one. Throws
/// Error where it is of another type or out of its range. `space` is that of rgb values.
Rgb color_of(const PbrtParameters& parameters, const PbrtParameter& parameter, ColorRole role,
             const PbrtFiles& files);
/// The same of the parameter with this name; `fallback` where there is none.
Rgb color_of(const PbrtParameters& parameters, const char* name, const Rgb& fallback, ColorRole role,
             const PbrtFiles& files);

}  // namespace twinray

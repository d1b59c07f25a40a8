// SPDX-License-Identifier: Apache-2.0
// Light below a surface: it enters a body, is scattered there, and comes out elsewhere.
#pragma once
#include "core/material.h"
#include "core/rgb.h"

namespace twinray {

/// The albedo of one scattering, in [0, 1], of a body whose flat surface reflects so much, in [0, 1], of
/// light that enters evenly from all sides: van de Hulst's fit (Multiple Light Scattering, 1980), solved for
/// the albedo as Kulla and Conty do ("Revisiting Physically Based Shading at Imageworks", 2017). Nothing is
/// reflected back down by the surface itself. The anisotropy is that of core/phase_function.h.
float single_scattering_albedo(float reflectance, float anisotropy);
/// The other way round.
float diffuse_reflectance(float albedo, float anisotropy);

/// The reflectance of the base, so that of light that has entered through the coat the part `emerging`, in
/// [0, 1], comes out again: what the coat reflects back down counts once more.
Rgb base_of_emerging(const CoatedDiffuse& model, const Rgb& emerging);
/// The other way round.
Rgb emerging_of_base(const CoatedDiffuse& model, const Rgb& reflectance);

/// What fills a body whose base reflects so much; even, and of no priority.
Interior medium_below(const Subsurface& subsurface, const Rgb& reflectance);

}  // namespace twinray

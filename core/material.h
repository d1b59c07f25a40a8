// SPDX-License-Identifier: Apache-2.0
// What a surface is made of, as a scene describes it: plain values. core/bsdf.h makes a scattering function
// of them.
#pragma once
#include <string>
#include <variant>

#include "core/rgb.h"

namespace twinray {

/// Reflects evenly in all directions, on both sides. Reflectance in [0, 1].
struct Lambert {
  Rgb reflectance{0.5f, 0.5f, 0.5f};
};

/// A perfect mirror. Reflectance in [0, 1].
struct Mirror {
  Rgb reflectance{1, 1, 1};
};

/// A smooth boundary that only refracts. Transmittance in [0, 1]; ior is that of the inside to the outside, >
/// 0.
struct Refraction {
  Rgb transmittance{1, 1, 1};
  float roughness = 0;
  float ior = 1.5f;
};

/// A smooth dielectric boundary: reflects and refracts by Fresnel's equations.
struct Glass {
  Rgb transmittance{1, 1, 1};
  Rgb reflectance{1, 1, 1};
  float roughness = 0;
  float ior = 1.5f;
};

/// A rough conductor: Beckmann facets of width alpha (> 0), complex index of refraction eta + i k per
/// channel.
struct Microfacet {
  float alpha = 0.5f;
  Rgb eta{0.2f, 0.9f, 1.1f};
  Rgb k{3.9f, 2.4f, 2.2f};
};

using SurfaceModel = std::variant<Lambert, Mirror, Refraction, Glass, Microfacet>;

struct Material {
  std::string name;
  SurfaceModel model = Lambert{};
};

}  // namespace twinray

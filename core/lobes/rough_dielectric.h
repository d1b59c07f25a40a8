// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/ggx_albedo.h"
#include "core/lobes/dielectric_facets.h"

namespace twinray {

/// A rough boundary between two media: its facets, and what is scattered by several of them, so that a
/// boundary that absorbs nothing loses nothing. wo.z > 0.
class RoughDielectricLobe {
 public:
  /// eta: index of refraction on the other side, to that on the viewer's, > 0 and not 1. Factors in [0, 1].
  /// A film is on the facets; what light does that meets several of them it does not change.
  RoughDielectricLobe(const Ggx& facets, float eta, const Rgb& reflectance, const Rgb& transmittance,
                      const std::optional<PartialFilm>& film = {});

  Rgb albedo() const { return transmittance_; }
  BsdfValue evaluate(const Vec3& wo, const Vec3& wi) const;
  BsdfSample sample(const Vec3& wo, float lobe, Vec2 u) const;

 private:
  /// The probability of sampling light that met several facets.
  float multiple_probability(const Vec3& wo) const;

  DielectricFacets facets_;
  DielectricMultipleScattering multiple_;
  float eta_;
  Rgb reflectance_, transmittance_;
};

}  // namespace twinray

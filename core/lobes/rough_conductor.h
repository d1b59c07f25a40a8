// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/bsdf_sample.h"
#include "core/ggx_albedo.h"
#include "core/microfacet.h"

namespace twinray {

/// A rough metal: GGX facets that reflect by Fresnel's equations (Cook and Torrance 1982, Walter et al.
/// 2007), and what they reflect to each other, so that facets that absorb nothing scatter everything.
/// Reflects on the viewer's side; wo.z > 0.
class RoughConductorLobe {
 public:
  /// Complex index of refraction eta + i k per channel, relative to the viewer's side; a factor in [0, 1].
  RoughConductorLobe(const Ggx& facets, const Rgb& eta, const Rgb& k, const Rgb& reflectance);

  Rgb albedo() const;
  BsdfValue evaluate(const Vec3& wo, const Vec3& wi) const;
  BsdfSample sample(const Vec3& wo, float lobe, Vec2 u) const;

  /// f(wo, wi) of the light that meets one facet only.
  Rgb single_scattering(const FacetReflection& facets) const;

 private:
  /// The probability of sampling light that met several facets.
  float multiple_probability(const Vec3& wo) const;

  Ggx facets_;
  MultipleScattering multiple_;
  Rgb eta_, k_, reflectance_;
  Rgb average_fresnel_, multiple_factor_;
};

}  // namespace twinray

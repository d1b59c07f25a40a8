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

  const Ggx& facets() const { return facets_; }
  const Rgb& eta() const { return eta_; }
  const Rgb& k() const { return k_; }
  const Rgb& reflectance() const { return reflectance_; }
  const Rgb& average_fresnel() const { return average_fresnel_; }
  /// What facets reflect to each other, and how much of that is not absorbed.
  const MultipleScattering& multiple() const { return multiple_; }
  const Rgb& multiple_factor() const { return multiple_factor_; }

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

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>

#include "core/bsdf_sample.h"
#include "core/microfacet.h"
#include "core/thin_film.h"

namespace twinray {

/// Light that meets one facet of a rough boundary between two media: GGX facets that reflect and refract by
/// Fresnel's equations (Walter et al., "Microfacet Models for Refraction through Rough Surfaces", 2007), as
/// in pbrt. wo.z > 0.
class DielectricFacets {
 public:
  /// eta: index of refraction on the other side, to that on the viewer's, > 0 and not 1. Factors in [0, 1].
  DielectricFacets(const Ggx& facets, float eta, const Rgb& reflectance, const Rgb& transmittance,
                   const std::optional<PartialFilm>& film = {})
      : facets_(facets), eta_(eta), reflectance_(reflectance), transmittance_(transmittance), film_(film) {}

  BsdfValue evaluate(const Vec3& wo, const Vec3& wi) const;
  BsdfSample sample(const Vec3& wo, float lobe, Vec2 u) const;

 private:
  /// Of directions on one side, and on two.
  BsdfValue evaluate_reflection(const Vec3& wo, const Vec3& wi) const;
  BsdfValue evaluate_transmission(const Vec3& wo, const Vec3& wi) const;
  /// The normal of facets that refract wi to wo, on the viewer's side: along wo + eta wi.
  Vec3 refracting_normal(const Vec3& wo, const Vec3& wi) const;
  /// The probability that a facet is taken to reflect, where it reflects this part.
  float reflection_probability(const Rgb& fresnel) const;
  /// What a facet reflects of light that meets it with this cosine.
  Rgb fresnel(float cosine) const;

  Ggx facets_;
  float eta_;
  Rgb reflectance_, transmittance_;
  std::optional<PartialFilm> film_;
};

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/bsdf_sample.h"

namespace twinray {

/// CS184's rough conductor, by its formulas: Beckmann facets of width alpha > 0; Fresnel's reflectance (meant
/// for a large eta^2 + k^2) at the angle of wi to the surface, not to the facet; a masking whose Lambda
/// divides by pi and not by its root. So it is not reciprocal, and close to the horizon it scatters up
/// to 1.65 times what it receives. wo.z > 0.
class Cs184MicrofacetLobe {
 public:
  Cs184MicrofacetLobe(float alpha, const Rgb& eta, const Rgb& k) : alpha_(alpha), eta_(eta), k_(k) {}

  Rgb albedo() const { return fresnel(1); }
  BsdfValue evaluate(const Vec3& wo, const Vec3& wi) const;
  BsdfSample sample(const Vec3& wo, float lobe, Vec2 u) const;

 private:
  Rgb fresnel(float cos_i) const;
  float density(const Vec3& m) const;
  float lambda(const Vec3& w) const;

  float alpha_;
  Rgb eta_, k_;
};

}  // namespace twinray

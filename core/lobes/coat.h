// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/bsdf_sample.h"
#include "core/ggx_albedo.h"
#include "core/microfacet.h"

namespace twinray {

/// The boundary of a layer of a clear dielectric on top of something else: what it reflects, and what it lets
/// through. Smooth, or with GGX facets; what facets do not reflect at once goes through. Seen from above,
/// wo.z > 0. An ior below 1 is taken as 1: no coat.
class Coat {
 public:
  explicit Coat(float ior);
  Coat(float ior, const Ggx& facets);

  bool is_smooth() const { return is_smooth_; }
  float ior() const { return ior_; }
  /// Of the facets; 0 if smooth.
  float alpha() const { return alpha_; }
  /// Of a rough coat.
  const Ggx& facets() const { return facets_; }
  /// That of mean_alpha().
  const GgxDielectricReflectance& rough_reflectance() const { return rough_reflectance_; }

  /// The part of light from a direction above, w.z > 0, that is reflected; the rest goes through.
  float reflectance(const Vec3& w) const;
  float transmittance(const Vec3& w) const { return 1 - reflectance(w); }
  /// The same of facets with mean_alpha(), for all directions of a cosine.
  float reflectance(float cosine) const;
  /// The same of light from all directions above. Of facets of two alphas that of mean_alpha(), which differs
  /// by up to 0.006.
  float average_reflectance() const { return average_reflectance_; }
  /// The part of light from all directions below that is reflected back down, most of it totally.
  float average_reflectance_below() const { return 1 - (1 - average_reflectance_) / (ior_ * ior_); }

  /// The f of a diffuse base of this reflectance, times pi, with all reflections between it and the coat, but
  /// for what the coat lets through of both directions.
  Rgb diffuse_below(const Rgb& reflectance) const;

  /// What the facets of a rough coat reflect: `value` is their f(wo, wi). Nothing for a smooth one, which
  /// reflects to a delta direction.
  FacetReflection reflection(const Vec3& wo, const Vec3& wi) const;
  /// Where it reflects wo to: has that density. May lie below the surface.
  Vec3 sample(const Vec3& wo, Vec2 u) const;

 private:
  bool is_smooth_;
  float ior_, alpha_;
  Ggx facets_;
  GgxDielectricReflectance rough_reflectance_;
  float average_reflectance_;
};

}  // namespace twinray

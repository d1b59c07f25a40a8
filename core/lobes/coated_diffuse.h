// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/lobes/coat.h"

namespace twinray {

/// A diffuse surface under a coat, with all reflections between the two: pbrt's layers without a medium, in
/// closed form. A diffuse base forgets where light came from, so that what leaves it is
///
///   f = T(wo) T(wi) / ior^2 * reflectance / (1 - reflectance R) / pi,
///
/// T: what the coat lets through along each direction, R: what it reflects back down of light from all
/// directions below. Reciprocal; a white base loses nothing, while pbrt's rough coats lose what their facets
/// scatter to each other. wo.z > 0.
class CoatedDiffuseLobe {
 public:
  /// Reflectance of the base, in [0, 1].
  CoatedDiffuseLobe(const Coat& coat, const Rgb& reflectance);

  const Coat& coat() const { return coat_; }
  /// The radiosity below the coat: reflectance / (1 - reflectance R) / ior^2.
  const Rgb& base() const { return base_; }
  Rgb albedo() const;
  BsdfValue evaluate(const Vec3& wo, const Vec3& wi) const;
  /// What of it comes from the base.
  Rgb diffuse(const Vec3& wo, const Vec3& wi) const;
  BsdfSample sample(const Vec3& wo, float lobe, Vec2 u) const;
  BelowSurface below(const Vec3& wo) const;
  Rgb of_below(const Vec3& wo, const Vec3& wi) const { return diffuse(wo, wi); }
  Rgb from_below(const Vec3& wi) const;

 private:
  /// The probability of sampling the coat's reflection.
  float coat_probability(float reflectance) const;

  Coat coat_;
  Rgb reflectance_, base_;
};

}  // namespace twinray

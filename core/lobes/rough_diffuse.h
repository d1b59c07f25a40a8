// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>

#include "core/bsdf_sample.h"
#include "core/warp.h"

namespace twinray {

/// A rough diffuse surface, brighter than Lambert's towards the light and at the rim: EON, the
/// energy-preserving Oren-Nayar model (Portsmouth, Kutz and Hill, "EON: A Practical Energy-Preserving Rough
/// Diffuse BRDF", JCGT 14(1), 2025), with its fitted albedo. wo.z > 0.
class RoughDiffuseLobe {
 public:
  /// Albedo of one event of scattering, and roughness, in [0, 1]. Roughness 0 is Lambert's.
  RoughDiffuseLobe(const Rgb& reflectance, float roughness);

  float roughness() const { return roughness_; }
  float scale() const { return scale_; }
  float average() const { return average_; }
  const Rgb& multiple() const { return multiple_; }

  Rgb albedo() const;
  BsdfValue evaluate(const Vec3& wo, const Vec3& wi) const;
  BsdfSample sample(const Vec3& wo, float lobe, Vec2 u) const;

 private:
  /// What a direction scatters in one event if nothing is absorbed: within 1e-3.
  float single_albedo(float cosine) const;

  Rgb reflectance_;
  float roughness_;
  float scale_;    ///< The model's A: what is left at normal incidence.
  float average_;  ///< single_albedo, averaged over all directions.
  Rgb multiple_;   ///< The albedo of what is scattered more than once.
};

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/vec.h"

namespace twinray {

/// A layer of fibres, bright at the rim, as cloth and dust are: facets that stand upright, without masking of
/// their own (A. Conty and C. Kulla, "Production Friendly Microfacet Sheen BRDF", 2017), with the visibility
/// of Neubelt and Pettineo (2013). White; what it does not scatter at once goes through.
class Fuzz {
 public:
  /// In [0, 1]; below 0.25, where more light would leave than arrives, as 0.25.
  explicit Fuzz(float roughness);

  /// f(wo, wi); both z > 0. Reciprocal.
  float evaluate(const Vec3& wo, const Vec3& wi) const;
  /// The part of light along a direction that is scattered: by a table, within 2e-3.
  float reflectance(float cosine) const;
  /// The same of light from all directions.
  float average_reflectance() const { return average_; }

 private:
  float exponent_, row_, average_;
};

}  // namespace twinray

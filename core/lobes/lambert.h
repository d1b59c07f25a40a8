// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>

#include "core/bsdf_sample.h"
#include "core/warp.h"

namespace twinray {

/// Reflects evenly in all directions of the viewer's side.
struct LambertLobe {
  Rgb reflectance;

  Rgb albedo() const { return reflectance; }
  BsdfValue evaluate(const Vec3& wo, const Vec3& wi) const {
    if (!(wo.z * wi.z > 0)) return {};
    return {reflectance * (1 / pi), cosine_hemisphere_pdf(std::fabs(wi.z))};
  }
  BsdfSample sample(const Vec3& wo, float /*lobe*/, Vec2 u) const {
    if (is_black(reflectance) || wo.z == 0) return {};
    Vec3 wi = square_to_cosine_hemisphere(u);
    if (wi.z <= 0) return {};
    const float pdf = cosine_hemisphere_pdf(wi.z);
    if (wo.z < 0) wi.z = -wi.z;
    return {.wi = wi, .value = reflectance * (1 / pi), .pdf = pdf, .is_diffuse = true};
  }
};

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>

#include "core/bsdf_sample.h"
#include "core/warp.h"

namespace twinray {

/// Scatters evenly to the viewer's side and evenly to the other, such as paper or a leaf. wo.z > 0.
struct DiffuseTransmissionLobe {
  Rgb reflectance, transmittance;  ///< Their sum in [0, 1].

  Rgb albedo() const { return reflectance + transmittance; }
  BsdfValue evaluate(const Vec3&, const Vec3& wi) const {
    const float reflects = reflection_probability();
    return {(wi.z > 0 ? reflectance : transmittance) * (1 / pi),
            (wi.z > 0 ? reflects : 1 - reflects) * cosine_hemisphere_pdf(std::fabs(wi.z))};
  }
  BsdfSample sample(const Vec3& wo, float lobe, Vec2 u) const {
    Vec3 wi = square_to_cosine_hemisphere(u);
    if (is_black(albedo()) || !(wi.z > 0)) return {};
    if (lobe >= reflection_probability()) wi.z = -wi.z;
    const auto [value, pdf] = evaluate(wo, wi);
    return {.wi = wi, .value = value, .pdf = pdf, .is_diffuse = true};
  }

 private:
  float reflection_probability() const {
    const float reflected = max_component(reflectance), transmitted = max_component(transmittance);
    return reflected > 0 ? reflected / (reflected + transmitted) : 0;
  }
};

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "core/lobes/coat.h"

#include "core/fresnel.h"
#include "core/ggx_albedo.h"

namespace twinray {

Coat::Coat(float ior)
    : is_smooth_(true),
      ior_(std::max(1.0f, ior)),
      alpha_(0),
      average_reflectance_(average_fresnel_dielectric(ior_)),
      facets_(1) {}

Coat::Coat(float ior, const Ggx& facets)
    : is_smooth_(false),
      ior_(std::max(1.0f, ior)),
      alpha_(facets.mean_alpha()),
      average_reflectance_(average_ggx_dielectric_reflectance(alpha_, ior_)),
      facets_(facets) {}

float Coat::reflectance(float cosine) const {
  return is_smooth_ ? fresnel_dielectric(cosine, ior_) : ggx_dielectric_reflectance(cosine, alpha_, ior_);
}

Rgb Coat::diffuse_below(const Rgb& reflectance) const {
  const float back = average_reflectance_below(), spread = ior_ * ior_;
  const auto channel = [&](float r) { return r / ((1 - r * back) * spread); };
  return {channel(reflectance.r), channel(reflectance.g), channel(reflectance.b)};
}

float Coat::evaluate(const Vec3& wo, const Vec3& wi) const {
  if (is_smooth_) return 0;
  const float cosine = std::min(1.0f, dot(wo, normalize(wo + wi)));
  return fresnel_dielectric(cosine, ior_) * facets_.reflection(wo, wi);
}

float Coat::pdf(const Vec3& wo, const Vec3& wi) const {
  return is_smooth_ ? 0 : facets_.reflection_pdf(wo, wi);
}

Vec3 Coat::sample(const Vec3& wo, Vec2 u) const {
  return is_smooth_ ? Vec3{-wo.x, -wo.y, wo.z} : reflected(wo, facets_.sample_visible(wo, u));
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "core/lobes/coat.h"

#include "core/fresnel.h"

namespace twinray {

Coat::Coat(float ior)
    : is_smooth_(true),
      ior_(std::max(1.0f, ior)),
      alpha_(0),
      facets_(1),
      rough_reflectance_(0, ior_),
      average_reflectance_(average_fresnel_dielectric(ior_)) {}

Coat::Coat(float ior, const Ggx& facets)
    : is_smooth_(false),
      ior_(std::max(1.0f, ior)),
      alpha_(facets.mean_alpha()),
      facets_(facets),
      rough_reflectance_(alpha_, ior_),
      average_reflectance_(rough_reflectance_.average()) {}

float Coat::reflectance(const Vec3& w) const {
  if (is_smooth_ || facets_.has_one_alpha()) return reflectance(w.z);
  return ggx_dielectric_reflectance(w.z, facets_.alpha_towards(w), ior_);
}

float Coat::reflectance(float cosine) const {
  return is_smooth_ ? fresnel_dielectric(cosine, ior_) : rough_reflectance_(cosine);
}

Rgb Coat::diffuse_below(const Rgb& reflectance) const {
  // r / ((1 - r back) ior^2), where of light from below 1 - back = (1 - average) / ior^2 gets out: written so
  // that nothing cancels where the index is large.
  const float out = 1 - average_reflectance_, spread = ior_ * ior_;
  const auto channel = [&](float r) { return r / ((1 - r) * spread + r * out); };
  return {channel(reflectance.r), channel(reflectance.g), channel(reflectance.b)};
}

FacetReflection Coat::reflection(const Vec3& wo, const Vec3& wi) const {
  if (is_smooth_) return {};
  FacetReflection facets = facets_.reflection(wo, wi);
  facets.value *= fresnel_dielectric(facets.cosine, ior_);
  return facets;
}

Vec3 Coat::sample(const Vec3& wo, Vec2 u) const {
  return is_smooth_ ? Vec3{-wo.x, -wo.y, wo.z} : reflected(wo, facets_.sample_visible(wo, u));
}

}  // namespace twinray

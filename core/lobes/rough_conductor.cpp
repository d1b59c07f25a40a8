// SPDX-License-Identifier: Apache-2.0
#include "core/lobes/rough_conductor.h"

#include "core/fresnel.h"

namespace twinray {

RoughConductorLobe::RoughConductorLobe(const Ggx& facets, const Rgb& eta, const Rgb& k,
                                       const Rgb& reflectance)
    : facets_(facets),
      multiple_(facets),
      eta_(eta),
      k_(k),
      reflectance_(reflectance),
      average_fresnel_(average_fresnel_conductor(eta, k)),
      multiple_factor_(multiple_.absorption(average_fresnel_)) {}

Rgb RoughConductorLobe::albedo() const {
  const float loss = multiple_.average_loss();
  return reflectance_ * (average_fresnel_ * (1 - loss) + multiple_factor_ * loss);
}

Rgb RoughConductorLobe::single_scattering(const Vec3& wo, const Vec3& wi) const {
  if (!(wo.z > 0 && wi.z > 0)) return {};
  const Vec3 m = normalize(wo + wi);
  const Rgb fresnel = fresnel_conductor(std::min(1.0f, dot(wo, m)), eta_, k_);
  return reflectance_ * fresnel * facets_.reflection(wo, wi);
}

Rgb RoughConductorLobe::evaluate(const Vec3& wo, const Vec3& wi) const {
  if (!(wo.z > 0 && wi.z > 0)) return {};
  return single_scattering(wo, wi) + reflectance_ * multiple_factor_ * multiple_.evaluate(wo.z, wi.z);
}

float RoughConductorLobe::multiple_probability(const Vec3& wo) const {
  const float loss = multiple_.loss(wo.z);
  const float once = (1 - loss) * max_component(average_fresnel_);
  const float more = loss * max_component(multiple_factor_);
  return more > 0 ? more / (once + more) : 0;
}

float RoughConductorLobe::pdf(const Vec3& wo, const Vec3& wi) const {
  if (!(wo.z > 0 && wi.z > 0)) return 0;
  const float multiple = multiple_probability(wo);
  return (1 - multiple) * facets_.reflection_pdf(wo, wi) + multiple * cosine_hemisphere_pdf(wi.z);
}

BsdfSample RoughConductorLobe::sample(const Vec3& wo, float lobe, Vec2 u) const {
  if (!(wo.z > 0)) return {};
  const bool is_multiple = lobe < multiple_probability(wo);
  const Vec3 wi = is_multiple ? square_to_cosine_hemisphere(u) : reflected(wo, facets_.sample_visible(wo, u));
  if (!(wi.z > 0)) return {};
  return {.wi = wi, .value = evaluate(wo, wi), .pdf = pdf(wo, wi)};
}

}  // namespace twinray

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

float RoughConductorLobe::multiple_probability(const Vec3& wo) const {
  const float loss = multiple_.loss(wo);
  const float once = (1 - loss) * max_component(average_fresnel_);
  const float more = loss * max_component(multiple_factor_);
  return more > 0 ? more / (once + more) : 0;
}

Rgb RoughConductorLobe::single_scattering(const FacetReflection& facets) const {
  return reflectance_ * fresnel_conductor(facets.cosine, eta_, k_) * facets.value;
}

BsdfValue RoughConductorLobe::evaluate(const Vec3& wo, const Vec3& wi) const {
  if (!(wo.z > 0 && wi.z > 0)) return {};
  const FacetReflection facets = facets_.reflection(wo, wi);
  const Rgb more = reflectance_ * multiple_factor_ * multiple_.evaluate(wo, wi);
  const float multiple = multiple_probability(wo);
  return {single_scattering(facets) + more,
          (1 - multiple) * facets.pdf + multiple * cosine_hemisphere_pdf(wi.z)};
}

BsdfSample RoughConductorLobe::sample(const Vec3& wo, float lobe, Vec2 u) const {
  if (!(wo.z > 0)) return {};
  const bool is_multiple = lobe < multiple_probability(wo);
  const Vec3 wi = is_multiple ? square_to_cosine_hemisphere(u) : reflected(wo, facets_.sample_visible(wo, u));
  if (!(wi.z > 0)) return {};
  const auto [value, pdf] = evaluate(wo, wi);
  return {.wi = wi, .value = value, .pdf = pdf};
}

}  // namespace twinray

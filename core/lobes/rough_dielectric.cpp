// SPDX-License-Identifier: Apache-2.0
#include "core/lobes/rough_dielectric.h"

namespace twinray {

RoughDielectricLobe::RoughDielectricLobe(const Ggx& facets, float eta, const Rgb& reflectance,
                                         const Rgb& transmittance, const std::optional<PartialFilm>& film)
    : facets_(facets, eta, reflectance, transmittance, film),
      multiple_(facets, eta),
      eta_(eta),
      reflectance_(reflectance),
      transmittance_(transmittance) {}

float RoughDielectricLobe::multiple_probability(const Vec3& wo) const {
  return is_black(reflectance_ + transmittance_) ? 0 : multiple_.loss(wo);
}

BsdfValue RoughDielectricLobe::evaluate(const Vec3& wo, const Vec3& wi) const {
  if (!(wo.z > 0) || wi.z == 0) return {};
  const BsdfValue once = facets_.evaluate(wo, wi);
  const Rgb more = wi.z > 0 ? reflectance_ * multiple_.reflection(wo, wi)
                            : transmittance_ * multiple_.transmission(wo, wi);
  const float multiple = multiple_probability(wo), reflected = multiple_.reflected_part();
  const float diffuse = (wi.z > 0 ? reflected : 1 - reflected) * cosine_hemisphere_pdf(std::fabs(wi.z));
  return {once.value + more, (1 - multiple) * once.pdf + multiple * diffuse};
}

BsdfSample RoughDielectricLobe::sample(const Vec3& wo, float lobe, Vec2 u) const {
  if (!(wo.z > 0)) return {};
  const float multiple = multiple_probability(wo);
  Vec3 wi;
  if (lobe < multiple) {
    wi = square_to_cosine_hemisphere(u);
    if (lobe >= multiple * multiple_.reflected_part()) wi.z = -wi.z;
  } else {
    const BsdfSample once = facets_.sample(wo, (lobe - multiple) / (1 - multiple), u);
    if (once.pdf == 0) return {};
    wi = once.wi;
  }
  if (wi.z == 0) return {};
  const auto [value, pdf] = evaluate(wo, wi);
  return {.wi = wi, .value = value, .pdf = pdf, .eta = wi.z > 0 ? 1 : eta_};
}

}  // namespace twinray

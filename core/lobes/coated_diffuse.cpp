// SPDX-License-Identifier: Apache-2.0
#include "core/lobes/coated_diffuse.h"

#include "core/warp.h"

namespace twinray {

CoatedDiffuseLobe::CoatedDiffuseLobe(const Coat& coat, const Rgb& reflectance)
    : coat_(coat), reflectance_(reflectance), base_(coat.diffuse_below(reflectance)) {}

Rgb CoatedDiffuseLobe::albedo() const {
  const float reflected = coat_.average_reflectance(), through = 1 - reflected;
  return Rgb{reflected, reflected, reflected} + base_ * (through * through);
}

Rgb CoatedDiffuseLobe::diffuse(const Vec3& wo, const Vec3& wi) const {
  if (!(wo.z > 0 && wi.z > 0)) return {};
  return base_ * (coat_.transmittance(wo) * coat_.transmittance(wi) / pi);
}

BelowSurface CoatedDiffuseLobe::below(const Vec3& wo) const {
  if (!(wo.z > 0)) return {};
  const float reflectance = coat_.reflectance(wo), probability = coat_probability(reflectance);
  const float out = 1 - coat_.average_reflectance();
  return {probability, 1 - probability, base_ * ((1 - reflectance) * out), reflectance_};
}

Rgb CoatedDiffuseLobe::from_below(const Vec3& wi) const {
  if (!(wi.z > 0)) return {};
  return white * (coat_.transmittance(wi) / ((1 - coat_.average_reflectance()) * pi));
}

float CoatedDiffuseLobe::coat_probability(float reflectance) const {
  const float through = (1 - reflectance) * (1 - coat_.average_reflectance());
  const float all = reflectance + through * max_component(base_);
  return all > 0 ? reflectance / all : 1;
}

BsdfValue CoatedDiffuseLobe::evaluate(const Vec3& wo, const Vec3& wi) const {
  if (!(wo.z > 0 && wi.z > 0)) return {};
  const FacetReflection coat = coat_.reflection(wo, wi);
  const float reflectance = coat_.reflectance(wo), probability = coat_probability(reflectance);
  const float through = (1 - reflectance) * coat_.transmittance(wi);
  return {Rgb{coat.value, coat.value, coat.value} + base_ * (through / pi),
          probability * coat.pdf + (1 - probability) * cosine_hemisphere_pdf(wi.z)};
}

BsdfSample CoatedDiffuseLobe::sample(const Vec3& wo, float lobe, Vec2 u) const {
  if (!(wo.z > 0)) return {};
  const float reflectance = coat_.reflectance(wo), probability = coat_probability(reflectance);
  const bool reflects = lobe < probability;
  const Vec3 wi = reflects ? coat_.sample(wo, u) : square_to_cosine_hemisphere(u);
  if (!(wi.z > 0)) return {};
  if (reflects && coat_.is_smooth()) {
    const float value = reflectance / wi.z;
    return {.wi = wi, .value = {value, value, value}, .pdf = probability, .is_delta = true};
  }
  const auto [value, pdf] = evaluate(wo, wi);
  return {.wi = wi, .value = value, .pdf = pdf, .is_diffuse = !reflects};
}

}  // namespace twinray

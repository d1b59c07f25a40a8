// SPDX-License-Identifier: Apache-2.0
#include "core/lobes/dielectric_facets.h"

#include "core/fresnel.h"

namespace twinray {
namespace {

/// wo refracted at the facet normal m, w.m > 0, into a medium of relative index eta; its z may have any sign.
Vec3 refracted(const Vec3& w, const Vec3& m, float cos_i, float eta) {
  return normalize(m * (cos_i / eta - refracted_cosine(cos_i, eta)) - w / eta);
}

}  // namespace

Vec3 DielectricFacets::refracting_normal(const Vec3& wo, const Vec3& wi) const {
  const Vec3 m = normalize(wo + wi * eta_);
  return m.z < 0 ? -m : m;
}

Rgb DielectricFacets::fresnel(float cosine) const {
  return film_ ? film_->reflectance(cosine, eta_) : white * fresnel_dielectric(cosine, eta_);
}

float DielectricFacets::reflection_probability(const Rgb& fresnel) const {
  const float reflected = max_component(fresnel * reflectance_);
  const float transmitted = max_component((white - fresnel) * transmittance_);
  return reflected > 0 ? reflected / (reflected + transmitted) : 0;
}

BsdfValue DielectricFacets::evaluate(const Vec3& wo, const Vec3& wi) const {
  if (!(wo.z > 0) || wi.z == 0) return {};
  return wi.z > 0 ? evaluate_reflection(wo, wi) : evaluate_transmission(wo, wi);
}

BsdfValue DielectricFacets::evaluate_reflection(const Vec3& wo, const Vec3& wi) const {
  const FacetReflection facets = facets_.reflection(wo, wi);
  const Rgb reflected = fresnel(facets.cosine);
  return {reflectance_ * (reflected * facets.value), reflection_probability(reflected) * facets.pdf};
}

BsdfValue DielectricFacets::evaluate_transmission(const Vec3& wo, const Vec3& wi) const {
  const Vec3 m = refracting_normal(wo, wi);
  const float cos_o = dot(wo, m), cos_i = dot(wi, m);
  if (!(cos_o > 0 && cos_i < 0)) return {};
  const float across = cos_o + eta_ * cos_i;
  const float facets = facets_.density(m) * facets_.shadowing_masking(wo, wi);
  const float geometry = cos_o * cos_i / (wo.z * wi.z * across * across);
  const Rgb reflected = fresnel(std::min(1.0f, cos_o));
  // Turning m turns wi: dm = eta^2 |wi.m| / (wo.m + eta wi.m)^2 dwi.
  const float turned = eta_ * eta_ * -cos_i / (across * across);
  return {transmittance_ * ((white - reflected) * facets * geometry),
          (1 - reflection_probability(reflected)) * facets_.visible_density(wo, m) * turned};
}

BsdfSample DielectricFacets::sample(const Vec3& wo, float lobe, Vec2 u) const {
  if (!(wo.z > 0)) return {};
  const Vec3 m = facets_.sample_visible(wo, u);
  const float cos_o = std::min(1.0f, dot(wo, m));
  if (!(cos_o > 0)) return {};
  const bool reflects = lobe < reflection_probability(fresnel(cos_o));
  const Vec3 wi = reflects ? reflected(wo, m) : refracted(wo, m, cos_o, eta_);
  if (reflects ? !(wi.z > 0) : !(wi.z < 0)) return {};
  const auto [value, pdf] = evaluate(wo, wi);
  return {.wi = wi, .value = value, .pdf = pdf, .eta = reflects ? 1 : eta_};
}

}  // namespace twinray

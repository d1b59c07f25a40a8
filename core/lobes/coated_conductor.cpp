// SPDX-License-Identifier: Apache-2.0
#include "core/lobes/coated_conductor.h"

#include "core/elementary.h"
#include "core/fresnel.h"

namespace twinray {
namespace {

Rgb divide(const Rgb& a, const Rgb& b) { return {a.r / b.r, a.g / b.g, a.b / b.b}; }

/// The facets of a metal with the tilts that a rough coat gives to light on its way in and out: each adds its
/// slope's variance times (1 - 1 / ior)^2, and half of the sum tilts the metal's facet.
Ggx seen_through(const Coat& coat, const Ggx& facets) {
  const float tilt = coat.alpha() * (1 - 1 / coat.ior()), added = 0.5f * tilt * tilt;
  return {std::sqrt(facets.alpha_x() * facets.alpha_x() + added),
          std::sqrt(facets.alpha_y() * facets.alpha_y() + added)};
}

/// The alpha of facets without direction of which as many are tilted by half the critical angle, so that they
/// reflect light along the normal to where the coat reflects all of it.
float alpha_of_tilts(const Ggx& facets, float ior) {
  if (facets.has_one_alpha()) return facets.mean_alpha();
  // The slope, tan(asin(1 / ior) / 2), is exceeded by 1 - slope^2 / sqrt((slope^2 + x^2) (slope^2 + y^2)).
  const float slope = 1 / (ior + std::sqrt(ior * ior - 1)), slope2 = slope * slope;
  const float x2 = facets.alpha_x() * facets.alpha_x(), y2 = facets.alpha_y() * facets.alpha_y();
  return std::sqrt(std::max(0.0f, std::sqrt((slope2 + x2) * (slope2 + y2)) - slope2));
}

}  // namespace

Rgb SmoothCoatedConductorLobe::reflected(float cosine) const {
  const float coat = fresnel_dielectric(cosine, ior_), through = 1 - coat;
  const Rgb metal = reflectance_ * fresnel_conductor(refracted_cosine(cosine, ior_), eta_, k_);
  return white * coat + divide(metal * (through * through), white - metal * coat);
}

BsdfSample SmoothCoatedConductorLobe::sample(const Vec3& wo, float /*lobe*/, Vec2 /*u*/) const {
  if (!(wo.z > 0)) return {};
  return {.wi = {-wo.x, -wo.y, wo.z}, .value = reflected(wo.z) / wo.z, .pdf = 1, .is_delta = true};
}

CoatedConductorLobe::CoatedConductorLobe(const Coat& coat, const Ggx& facets, const Rgb& eta, const Rgb& k,
                                         const Rgb& reflectance)
    : coat_(coat),
      metal_(seen_through(coat, facets), eta, k, reflectance),
      log_alpha_(log_of(std::min(1.0f, alpha_of_tilts(metal_.facets(), coat.ior())))),
      mean_kept_(0.13965396f * kept(0.21234054f) + 0.45848221f * kept(0.59053314f) +
                 0.40186383f * kept(0.91141204f)) {
  const Rgb metal = metal_.albedo();
  const float back = coat.average_reflectance_below();
  diffuse_ = divide(metal * metal * (1 - back), white - metal * back);
}

float CoatedConductorLobe::kept(float cosine) const {
  // Fitted to walks at an ior of 1.5: from what the coat reflects, for a smooth metal, to what it reflects
  // back of light from all directions, for a rough one.
  const float power = 0.25f + cosine * (1 + 0.65f * cosine), scale = 4.3f + 4.7f * cosine;
  const float scattered = 1 - exp_of(-scale * exp_of(power * log_alpha_));
  return scattered * std::max(0.0f, coat_.average_reflectance_below() - coat_.reflectance(cosine));
}

Vec3 CoatedConductorLobe::below(const Vec3& w) const {
  return {w.x / coat_.ior(), w.y / coat_.ior(), refracted_cosine(w.z, coat_.ior())};
}

Rgb CoatedConductorLobe::albedo() const {
  const float reflected = coat_.average_reflectance();
  return white * reflected + metal_.albedo() * (1 - reflected - mean_kept_) + diffuse_ * mean_kept_;
}

CoatedConductorLobe::Choice CoatedConductorLobe::choice(float cosine) const {
  const float reflected = coat_.reflectance(cosine), more = kept(cosine);
  const float metal = (1 - reflected - more) * max_component(metal_.albedo());
  const float all = reflected + metal + more * max_component(diffuse_);
  return all > 0 ? Choice{reflected / all, metal / all} : Choice{1, 0};
}

BsdfValue CoatedConductorLobe::evaluate(const Vec3& wo, const Vec3& wi) const {
  if (!(wo.z > 0 && wi.z > 0)) return {};
  const float out = coat_.reflectance(wo), in = coat_.reflectance(wi), squared = coat_.ior() * coat_.ior();
  const Vec3 inside = below(wi);
  const FacetReflection coat = coat_.reflection(wo, wi);
  const BsdfValue below_coat = metal_.evaluate(below(wo), inside);
  const Rgb once = below_coat.value * ((1 - out) * (1 - in) / squared);
  const Rgb metal = divide(once, white - metal_.albedo() * (0.5f * (out + in)));
  const float more = mean_kept_ > 0 ? kept(wo.z) * kept(wi.z) / (pi * mean_kept_) : 0;
  const Choice p = choice(wo.z);
  // Snell's law: cos dw is ior^2 times smaller within the coat.
  const float narrower = wi.z / (squared * inside.z);
  return {white * coat.value + metal + diffuse_ * more,
          p.coat * coat.pdf + p.metal * below_coat.pdf * narrower +
              (1 - p.coat - p.metal) * cosine_hemisphere_pdf(wi.z)};
}

BsdfSample CoatedConductorLobe::sample(const Vec3& wo, float lobe, Vec2 u) const {
  if (!(wo.z > 0)) return {};
  const Choice p = choice(wo.z);
  Vec3 wi;
  if (lobe < p.coat) {
    wi = coat_.sample(wo, u);
    const Rgb factor = white * coat_.reflectance(wo);
    if (coat_.is_smooth()) return {.wi = wi, .value = factor / wi.z, .pdf = p.coat, .is_delta = true};
  } else if (lobe < p.coat + p.metal) {
    const Vec3 inside = metal_.sample(below(wo), (lobe - p.coat) / p.metal, u).wi * coat_.ior();
    const float sin2 = inside.x * inside.x + inside.y * inside.y;
    wi = {inside.x, inside.y, inside.z > 0 && sin2 < 1 ? std::sqrt(1 - sin2) : 0};
  } else {
    wi = square_to_cosine_hemisphere(u);
  }
  if (!(wi.z > 0)) return {};
  const auto [value, pdf] = evaluate(wo, wi);
  return {.wi = wi, .value = value, .pdf = pdf};
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "core/lobes/specular.h"

#include <cmath>

#include "core/fresnel.h"
#include "core/refract.h"

namespace twinray {
namespace {

/// A delta direction that gets `factor` of the light from there, chosen with a probability.
BsdfSample delta_sample(const Vec3& wi, const Rgb& factor, float probability, float eta = 1) {
  return {wi, factor / std::fabs(wi.z), probability, true, eta};
}

Vec3 mirrored(const Vec3& wo) { return {-wo.x, -wo.y, wo.z}; }

/// The part of what is scattered that goes each way, as a probability of the first.
float share(const Rgb& first, const Rgb& second) {
  const float a = max_component(first), b = max_component(second);
  return a + b > 0 ? a / (a + b) : 0;
}

}  // namespace

BsdfSample MirrorLobe::sample(const Vec3& wo, float /*lobe*/, Vec2 /*u*/) const {
  if (wo.z == 0 || is_black(reflectance)) return {};
  return delta_sample(mirrored(wo), reflectance, 1);
}

Rgb SmoothConductorLobe::albedo() const { return reflectance * fresnel_conductor(1, eta, k); }

BsdfSample SmoothConductorLobe::sample(const Vec3& wo, float /*lobe*/, Vec2 /*u*/) const {
  if (wo.z == 0) return {};
  return delta_sample(mirrored(wo), reflectance * fresnel_conductor(std::fabs(wo.z), eta, k), 1);
}

BsdfSample SmoothDielectricLobe::sample(const Vec3& wo, float lobe, Vec2 /*u*/) const {
  if (wo.z == 0) return {};
  const float fresnel = fresnel_dielectric(std::fabs(wo.z), eta);
  const Rgb reflected = reflectance * fresnel, transmitted = transmittance * (1 - fresnel);
  const float probability = share(reflected, transmitted);
  if (lobe < probability) return delta_sample(mirrored(wo), reflected, probability);
  const auto wi = refract(wo, eta);
  if (!wi || is_black(transmitted)) return {};
  return delta_sample(*wi, transmitted / (eta * eta), 1 - probability, eta);
}

BsdfSample RefractionLobe::sample(const Vec3& wo, float /*lobe*/, Vec2 /*u*/) const {
  const auto wi = refract(wo, eta);
  if (!wi || is_black(transmittance)) return {};
  return delta_sample(*wi, transmittance / (eta * eta), 1, eta);
}

BsdfSample PassageLobe::sample(const Vec3& wo, float /*lobe*/, Vec2 /*u*/) const {
  if (wo.z == 0) return {};
  return delta_sample(-wo, {1, 1, 1}, 1);
}

BsdfSample ThinDielectricLobe::sample(const Vec3& wo, float lobe, Vec2 /*u*/) const {
  if (wo.z == 0) return {};
  const float cosine = std::fabs(wo.z);
  const Rgb once = film ? film->reflectance(cosine, eta) : white * fresnel_dielectric(cosine, eta);
  // R + T R T + T R R R T + ...: the light that is reflected within the sheet once, three times, ...
  const auto in_all = [](float r) { return 2 * r / (1 + r); };
  const Rgb fresnel = is_single ? once : Rgb{in_all(once.r), in_all(once.g), in_all(once.b)};
  const Rgb reflected = reflectance * fresnel, transmitted = transmittance * (white - fresnel);
  const float probability = share(reflected, transmitted);
  if (lobe < probability) return delta_sample(mirrored(wo), reflected, probability);
  if (is_black(transmitted)) return {};
  return delta_sample(-wo, transmitted, 1 - probability);
}

}  // namespace twinray

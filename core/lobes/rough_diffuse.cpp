// SPDX-License-Identifier: Apache-2.0
#include "core/lobes/rough_diffuse.h"

namespace twinray {
namespace {

constexpr float a_constant = 0.5f - 2 / (3 * pi), average_constant = 2.0f / 3 - 28 / (15 * pi);

}  // namespace

RoughDiffuseLobe::RoughDiffuseLobe(const Rgb& reflectance, float roughness)
    : reflectance_(reflectance),
      roughness_(roughness),
      scale_(1 / (1 + a_constant * roughness)),
      average_(scale_ * (1 + average_constant * roughness)) {
  const auto channel = [&](float r) { return r * r * average_ / (1 - r * (1 - average_)); };
  multiple_ = {channel(reflectance.r), channel(reflectance.g), channel(reflectance.b)};
}

Rgb RoughDiffuseLobe::albedo() const { return reflectance_ * average_ + multiple_ * (1 - average_); }

float RoughDiffuseLobe::single_albedo(float cosine) const {
  const float x = 1 - cosine;
  const float rim = x * (0.0571085289f + x * (0.491881867f + x * (-0.332181442f + x * 0.0714429953f)));
  return scale_ * (1 + roughness_ * rim);
}

BsdfValue RoughDiffuseLobe::evaluate(const Vec3& wo, const Vec3& wi) const {
  if (!(wo.z > 0 && wi.z > 0)) return {};
  const float s = wo.x * wi.x + wo.y * wi.y;  // The sines of both times the cosine of the azimuth between.
  const float tilt = s > 0 ? s / std::max(wo.z, wi.z) : s;
  const Rgb once = reflectance_ * (scale_ * (1 + roughness_ * tilt));
  // The fit may be a little above 1.
  constexpr float least = 1e-7f;
  const float missing = std::max(least, 1 - single_albedo(wo.z)) * std::max(least, 1 - single_albedo(wi.z));
  return {(once + multiple_ * (missing / std::max(least, 1 - average_))) * (1 / pi),
          cosine_hemisphere_pdf(wi.z)};
}

BsdfSample RoughDiffuseLobe::sample(const Vec3& wo, float /*lobe*/, Vec2 u) const {
  const Vec3 wi = square_to_cosine_hemisphere(u);
  if (is_black(reflectance_) || !(wo.z > 0 && wi.z > 0)) return {};
  const auto [value, pdf] = evaluate(wo, wi);
  return {.wi = wi, .value = value, .pdf = pdf, .is_diffuse = true};
}

}  // namespace twinray

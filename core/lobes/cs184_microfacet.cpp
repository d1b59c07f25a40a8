// SPDX-License-Identifier: Apache-2.0
#include "core/lobes/cs184_microfacet.h"

#include <cmath>

#include "core/elementary.h"
#include "core/microfacet.h"
#include "core/warp.h"

namespace twinray {
namespace {

float fresnel_of(float cos_i, float eta, float k) {
  const float squares = eta * eta + k * k, cos2 = cos_i * cos_i, across = 2 * eta * cos_i;
  const float perpendicular = (squares - across + cos2) / (squares + across + cos2);
  const float parallel = (squares * cos2 - across + 1) / (squares * cos2 + across + 1);
  return 0.5f * (perpendicular + parallel);
}

}  // namespace

Rgb Cs184MicrofacetLobe::fresnel(float cos_i) const {
  return {fresnel_of(cos_i, eta_.r, k_.r), fresnel_of(cos_i, eta_.g, k_.g), fresnel_of(cos_i, eta_.b, k_.b)};
}

/// exp(-tan^2 / alpha^2) / (pi alpha^2 cos^4).
float Cs184MicrofacetLobe::density(const Vec3& m) const {
  const float cos2 = m.z * m.z, alpha2 = alpha_ * alpha_;
  const float tan2 = (m.x * m.x + m.y * m.y) / cos2;
  if (!(tan2 < 87 * alpha2)) return 0;  // exp_of() is 0, and cos2^2 may be.
  return exp_of(-tan2 / alpha2) / (pi * alpha2 * cos2 * cos2);
}

float Cs184MicrofacetLobe::lambda(const Vec3& w) const {
  const float sine = std::sqrt(w.x * w.x + w.y * w.y);
  if (sine == 0) return 0;
  const float a = w.z / (alpha_ * sine);
  return 0.5f * (exp_of(-a * a) / (a * pi) - erfc_of(a));
}

BsdfValue Cs184MicrofacetLobe::evaluate(const Vec3& wo, const Vec3& wi) const {
  if (!(wo.z > 0 && wi.z > 0)) return {};
  const Vec3 m = normalize(wo + wi);
  const float cosine = dot(wo, m);
  if (!(cosine > 0)) return {};  // By rounding, where both graze the surface from opposite sides.
  const float facets = density(m), masking = 1 / (1 + lambda(wo) + lambda(wi));
  return {fresnel(wi.z) * (masking * facets / (4 * wo.z * wi.z)), facets * m.z / (4 * cosine)};
}

BsdfSample Cs184MicrofacetLobe::sample(const Vec3& wo, float /*lobe*/, Vec2 u) const {
  if (!(wo.z > 0)) return {};
  const float tangent = alpha_ * std::sqrt(-log_of(1 - u.x));
  const SinCos azimuth = sincos_turns(u.y);
  const Vec3 wi = reflected(wo, normalize({tangent * azimuth.cos, tangent * azimuth.sin, 1}));
  if (!(wi.z > 0)) return {};
  const auto [value, pdf] = evaluate(wo, wi);
  return {.wi = wi, .value = value, .pdf = pdf};
}

}  // namespace twinray

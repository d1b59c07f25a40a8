// SPDX-License-Identifier: Apache-2.0
#include "core/bsdf.h"

namespace twinray {
namespace {

/// ((eta - 1)^2 + k^2) / ((eta + 1)^2 + k^2): a conductor seen along its normal.
float normal_fresnel(float eta, float k) {
  const float minus = (eta - 1) * (eta - 1), plus = (eta + 1) * (eta + 1);
  return (minus + k * k) / (plus + k * k);
}

struct LambertReflectance {
  Rgb operator()(const Lambert& m) const { return m.reflectance; }
  Rgb operator()(const Mirror& m) const { return m.reflectance; }
  Rgb operator()(const Refraction& m) const { return m.transmittance; }
  Rgb operator()(const Glass& m) const { return m.transmittance; }
  Rgb operator()(const Microfacet& m) const {
    return {normal_fresnel(m.eta.r, m.k.r), normal_fresnel(m.eta.g, m.k.g), normal_fresnel(m.eta.b, m.k.b)};
  }
};

}  // namespace

Rgb lambert_reflectance(const SurfaceModel& model) { return std::visit(LambertReflectance{}, model); }

Bsdf::Bsdf(const Material& material) : reflectance_(lambert_reflectance(material.model)) {}

float Bsdf::pdf(const Vec3& wo, const Vec3& wi) const {
  return wo.z * wi.z > 0 ? cosine_hemisphere_pdf(std::fabs(wi.z)) : 0;
}

BsdfSample Bsdf::sample(const Vec3& wo, Vec2 u) const {
  if (is_black(reflectance_) || wo.z == 0) return {};
  Vec3 wi = square_to_cosine_hemisphere(u);
  if (wi.z <= 0) return {};
  const float pdf = cosine_hemisphere_pdf(wi.z);
  if (wo.z < 0) wi.z = -wi.z;
  return {wi, reflectance_ * (1 / pi), pdf};
}

}  // namespace twinray

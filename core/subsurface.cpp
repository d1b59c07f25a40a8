// SPDX-License-Identifier: Apache-2.0
#include "core/subsurface.h"

#include <algorithm>
#include <cmath>

#include "core/bsdf.h"

namespace twinray {

// With s = sqrt((1 - albedo) / (1 - albedo g)), the reflectance is (1 - s) (1 - 0.139 s) / (1 + 1.17 s).
float diffuse_reflectance(float albedo, float anisotropy) {
  const float s = std::sqrt((1 - albedo) / (1 - albedo * anisotropy));
  return (1 - s) * (1 - 0.139f * s) / (1 + 1.17f * s);
}

float single_scattering_albedo(float reflectance, float anisotropy) {
  // 0.139 s^2 - (1.139 + 1.17 r) s + (1 - r) = 0; its lesser root, so written that nothing cancels.
  const float r = std::clamp(reflectance, 0.0f, 1.0f), b = 1.139f + 1.17f * r;
  const float s = std::min(2 * (1 - r) / (b + std::sqrt(b * b - 4 * 0.139f * (1 - r))), 1.0f);
  return (1 - s * s) / (1 - anisotropy * s * s);
}

namespace {

float reflected_back_down(const CoatedDiffuse& model) {
  return Bsdf(model).as<CoatedDiffuseLobe>()->coat().average_reflectance_below();
}

}  // namespace

Rgb base_of_emerging(const CoatedDiffuse& model, const Rgb& emerging) {
  const float back = reflected_back_down(model);
  const auto channel = [&](float e) { return e / (1 - back + e * back); };
  return {channel(emerging.r), channel(emerging.g), channel(emerging.b)};
}

Rgb emerging_of_base(const CoatedDiffuse& model, const Rgb& reflectance) {
  const float back = reflected_back_down(model);
  const auto channel = [&](float r) { return r * (1 - back) / (1 - r * back); };
  return {channel(reflectance.r), channel(reflectance.g), channel(reflectance.b)};
}

Interior medium_below(const Subsurface& subsurface, const Rgb& reflectance) {
  Interior medium;
  const auto channel = [&](float radius, float r, float& scattering, float& absorption) {
    const float albedo = single_scattering_albedo(r, subsurface.anisotropy);
    scattering = albedo / radius;
    absorption = (1 - albedo) / radius;
  };
  const Rgb& radius = subsurface.radius;
  channel(radius.r, reflectance.r, medium.scattering.r, medium.absorption.r);
  channel(radius.g, reflectance.g, medium.scattering.g, medium.absorption.g);
  channel(radius.b, reflectance.b, medium.scattering.b, medium.absorption.b);
  medium.anisotropy = subsurface.anisotropy;
  return medium;
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#include "core/lobes/hair.h"

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/fresnel.h"

namespace twinray {
namespace {

/// Beyond it all light is reflected, but for rounding.
constexpr float largest_ior = 1e4f;

constexpr float largest_draw = 0x1.fffffep-1f;

float square(float x) { return x * x; }

float cosine_of(float sine) { return std::sqrt(std::max(0.0f, 1 - sine * sine)); }

/// x^n.
float power(float x, int n) {
  float product = 1;
  for (int i = 0; i < n; ++i) product *= x;
  return product;
}

/// The angle of the point (cosine, sine), in radians in [-pi, pi].
float angle_of(float sine, float cosine) {
  const double turns = atan2_turns(double(sine), double(cosine));
  return float((turns > 0.5 ? turns - 1 : turns) * 6.283185307179586);
}

SinCos sincos_of(float radians) {
  const double turns = double(radians) * turns_per_radian;
  return sincos_turns(float(turns - std::floor(turns)));
}

SinCos sum_of(const SinCos& a, const SinCos& b) {
  return {a.sin * b.cos + a.cos * b.sin, a.cos * b.cos - a.sin * b.sin};
}

/// e^-x I0(x), the modified Bessel function of the first kind, x >= 0 (Abramowitz and Stegun, 9.8.1 and
/// 9.8.2: to 2e-7).
float scaled_bessel(float x) {
  const float t = x / 3.75f;
  if (t < 1) {
    const float s = t * t;
    return exp_of(-x) *
           (1 +
            s * (3.5156229f +
                 s * (3.0899424f + s * (1.2067492f + s * (0.2659732f + s * (0.0360768f + s * 0.0045813f))))));
  }
  const float r = 1 / t;
  const float series =
      0.39894228f +
      r * (0.01328592f +
           r * (0.00225319f +
                r * (-0.00157565f +
                     r * (0.00916281f +
                          r * (-0.02057706f + r * (0.02635537f + r * (-0.01647633f + r * 0.00392377f)))))));
  return series / std::sqrt(x);
}

/// 1 / (1 + e^(-x / s)).
float logistic_below(float x, float s) { return 1 / (1 + exp_of(-x / s)); }

float reach_of_color(float beta) {
  return 5.969f + beta * (-0.215f + beta * (2.532f + beta * (-10.73f + beta * (5.574f + beta * 0.245f))));
}

}  // namespace

Rgb hair_absorption(const Rgb& reflectance, float azimuthal_roughness) {
  const float reach = reach_of_color(azimuthal_roughness);
  const auto channel = [&](float c) { return square(log_of(std::clamp(c, 1e-30f, 1.0f)) / reach); };
  return {channel(reflectance.r), channel(reflectance.g), channel(reflectance.b)};
}

Rgb hair_reflectance(const Rgb& absorption, float azimuthal_roughness) {
  const float reach = reach_of_color(azimuthal_roughness);
  const auto channel = [&](float a) { return std::min(exp_of(-reach * std::sqrt(a)), 1.0f); };
  return {channel(absorption.r), channel(absorption.g), channel(absorption.b)};
}

HairLobe::HairLobe(const Hair& model)
    : reflectance_(model.reflectance),
      absorption_(hair_absorption(model.reflectance, model.azimuthal_roughness)),
      ior_(std::clamp(model.ior, 1.0f, largest_ior)) {
  // Fits of what is called roughness to a variance along the fibre, and to a width around it.
  const float m = std::max(model.longitudinal_roughness, least_hair_roughness);
  const float n = std::max(model.azimuthal_roughness, least_hair_roughness);
  const float variance = square(0.726f * m + 0.812f * m * m + 3.7f * power(m, 20));
  const float tilt = model.scale_tilt;
  spreads_ = {spread(variance, -2 * tilt), spread(0.25f * variance, tilt), spread(4 * variance, 4 * tilt),
              spread(4 * variance, 0)};
  width_ = 0.62665706866f * (0.265f * n + 1.194f * n * n + 5.372f * power(n, 22));  // sqrt(pi / 8)
  below_ = logistic_below(-pi, width_);
  inside_ = logistic_below(pi, width_) - below_;
}

HairLobe::Spread HairLobe::spread(float variance, float tilt_degrees) const {
  return {variance, 1 / (variance * (1 - exp_of(-2 / variance))),
          sincos_of(float(double(tilt_degrees) * radians_per_degree))};
}

void HairLobe::attenuate(float cosine, float way, Seen& at) const {
  const float reflected = fresnel_dielectric(std::min(cosine, 1.0f), ior_);
  const auto channel = [&](float a) { return exp_of(-a * way); };
  const Rgb through{channel(absorption_.r), channel(absorption_.g), channel(absorption_.b)};
  const Rgb again = through * reflected;
  at.attenuations[0] = {reflected, reflected, reflected};
  at.attenuations[1] = through * square(1 - reflected);
  at.attenuations[2] = at.attenuations[1] * again;
  const auto rest = [](float next, float ratio) { return ratio < 1 ? next / (1 - ratio) : 0.0f; };
  const Rgb next = at.attenuations[2] * again;
  at.attenuations[3] = {rest(next.r, again.r), rest(next.g, again.g), rest(next.b, again.b)};
  float sum = 0;
  for (std::size_t p = 0; p < lobes; ++p) {
    const Rgb& a = at.attenuations[p];
    at.probability[p] = (a.r + a.g + a.b) / 3;
    sum += at.probability[p];
  }
  if (sum == 0) return;  // Nothing is scattered.
  for (float& probability : at.probability) probability /= sum;
}

HairLobe::Seen HairLobe::seen(const Vec3& wo) const {
  Seen at;
  at.sine = std::clamp(wo.x, -1.0f, 1.0f);
  at.cosine = cosine_of(at.sine);
  at.azimuth = angle_of(wo.y, wo.z);
  // Since z is the normal, it is the angle by which light meets the fibre, too: gamma.
  const float across = std::sqrt(wo.y * wo.y + wo.z * wo.z);
  const float sin_gamma = across > 0 ? std::clamp(wo.y / across, -1.0f, 1.0f) : 0;
  // Within the fibre, seen along its axis, light is refracted by an index of its own.
  const float cos_within = cosine_of(at.sine / ior_);
  const float ior_across =
      std::sqrt(std::max(ior_ * ior_ - at.sine * at.sine, 1e-8f)) / std::max(at.cosine, 1e-4f);
  const float sin_gamma_within = std::clamp(sin_gamma / ior_across, -1.0f, 1.0f);
  const float gamma_within = angle_of(sin_gamma_within, cosine_of(sin_gamma_within));
  for (std::size_t p = 0; p < at.turns.size(); ++p)
    at.turns[p] = 2 * float(p) * gamma_within - 2 * at.azimuth + float(p) * pi;
  attenuate(at.cosine * cosine_of(sin_gamma), 2 * cosine_of(sin_gamma_within) / std::max(cos_within, 1e-4f),
            at);
  for (std::size_t p = 0; p < lobes; ++p) {
    at.tilted[p] = sum_of({at.sine, at.cosine}, spreads_[p].tilt);
    at.tilted[p].cos = std::fabs(at.tilted[p].cos);
  }
  return at;
}

float HairLobe::along(const Spread& spread, const SinCos& from, const SinCos& to) const {
  const double v = double(spread.variance);
  const double cosines = double(from.cos) * double(to.cos), sines = double(from.sin) * double(to.sin);
  return scaled_bessel(float(cosines / v)) * exp_of(float((cosines - sines - 1) / v)) * spread.normalisation;
}

float HairLobe::around(float azimuth, float turn) const {
  const double turns = double(azimuth - turn) * turns_per_radian;
  const float x = std::fabs(float((turns - std::floor(turns + 0.5)) * 6.283185307179586));
  const float e = exp_of(-x / width_);
  return e / (width_ * square(1 + e)) / inside_;
}

BsdfValue HairLobe::evaluate(const Vec3& wo, const Vec3& wi) const {
  const Seen at = seen_ ? *seen_ : seen(wo);
  const float sine = std::clamp(wi.x, -1.0f, 1.0f);
  const SinCos to{sine, cosine_of(sine)};
  const float azimuth = angle_of(wi.y, wi.z) - at.azimuth;
  BsdfValue found;
  for (std::size_t p = 0; p < lobes; ++p) {
    const float density = along(spreads_[p], at.tilted[p], to) *
                          (p < at.turns.size() ? around(azimuth, at.turns[p]) : 1 / (2 * pi));
    found.value += at.attenuations[p] * density;
    found.pdf += at.probability[p] * density;
  }
  // Who uses it multiplies by a surface's cosine, which a fibre has not.
  const float cosine = std::fabs(wi.z);
  found.value = cosine > 0 ? found.value / cosine : Rgb{};
  return found;
}

BsdfSample HairLobe::sample(const Vec3& wo, float lobe, Vec2 u) const {
  const Seen at = seen_ ? *seen_ : seen(wo);
  std::size_t p = 0;
  float rest = lobe;
  while (p + 1 < lobes && rest >= at.probability[p]) rest -= at.probability[p++];
  if (!(at.probability[p] > 0)) return {};
  rest = std::min(rest / at.probability[p], largest_draw);
  // By the cosine to the direction of the lobe's mirror, then around that.
  const Spread& spread = spreads_[p];
  const float narrow = exp_of(-2 / spread.variance);
  const float cosine =
      std::max(1 + spread.variance * log_of(std::max(u.x, 0x1p-24f) + (1 - u.x) * narrow), -1.0f);
  const float sine = cosine_of(cosine);
  const SinCos& tilted = at.tilted[p];
  const float sin_to =
      std::clamp(-cosine * tilted.sin + sine * sincos_turns(u.y).cos * tilted.cos, -1.0f, 1.0f);
  float azimuth = at.azimuth;
  if (p < at.turns.size()) {
    const float within = std::max(rest * inside_ + below_, 1e-30f);
    const float x = -width_ * log_of(std::max(1 / within - 1, 1e-30f));
    azimuth += at.turns[p] + std::clamp(x, -pi, pi);
  } else {
    azimuth += 2 * pi * rest;
  }
  const SinCos around = sincos_of(azimuth);
  const float cos_to = cosine_of(sin_to);
  const Vec3 wi{sin_to, cos_to * around.sin, cos_to * around.cos};
  if (wi.z == 0) return {};
  const auto [value, pdf] = evaluate(wo, wi);
  return {.wi = wi, .value = value, .pdf = pdf};
}

}  // namespace twinray

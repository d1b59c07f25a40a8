// SPDX-License-Identifier: Apache-2.0
// The numbers are in core/ggx_albedo_tables.h; here they are interpolated.
#include "core/ggx_albedo.h"

#include "core/fresnel.h"
#include "core/ggx_albedo_tables.h"
#include "core/ggx_boundary_tables.h"

namespace twinray {
namespace {

/// Between two rows of a table with `count` equally spaced ones over [0, 1].
struct Place {
  int first;
  float part;

  Place(float x, int count) {
    const float scaled = (x > 0 ? std::min(x, 1.0f) : 0) * float(count - 1);
    first = std::min(int(scaled), count - 2);
    part = scaled - float(first);
  }
};

float mix(float a, float b, float part) { return a + (b - a) * part; }

float at(const float* row, Place x) { return mix(row[x.first], row[x.first + 1], x.part); }

template <int count>
float at(const float (*table)[count], Place y, Place x) {
  return mix(at(table[y.first], x), at(table[y.first + 1], x), y.part);
}

/// By the fourth root of the reflectance along the normal, relative to that of an ior of 3.
Place place_of_ior(float ior, int count) {
  return {std::sqrt(std::max(0.0f, 2 * (ior - 1) / (ior + 1))), count};
}

/// Where losses stand for a direction: they depend on how its cosine compares with alpha, mostly.
Place place_of_angle(float cosine, float alpha, int count) {
  return {std::sqrt(cosine * (1 + alpha) / std::max(cosine + alpha, 1e-6f)), count};
}

/// The rows of boundaries into the denser medium, or out of it, around an index.
struct BoundaryPlace {
  bool is_inside;
  Place layer;

  explicit BoundaryPlace(float eta)
      : is_inside(eta < 1), layer(place_of_ior(eta < 1 ? 1 / eta : eta, tables::boundary_ior_count)) {}
};

constexpr float last_ior = 3;  // of the tables

/// What facets reflect of light along a direction, and away from all others: by the midpoints of equal parts
/// of the normals that it sees.
float reflected_part(const Ggx& facets, float ior, float cosine) {
  constexpr int parts = 12;
  const Vec3 wo{std::sqrt(1 - cosine * cosine), 0, cosine};
  float sum = 0;
  for (int i = 0; i < parts * parts; ++i) {
    const Vec3 m =
        facets.sample_visible(wo, {(float(i % parts) + 0.5f) / parts, (float(i / parts) + 0.5f) / parts});
    const Vec3 wi = reflected(wo, m);
    if (wi.z > 0)
      sum += fresnel_dielectric(std::min(1.0f, dot(wo, m)), ior) * facets.shadowing_masking(wo, wi) /
             facets.masking(wo);
  }
  return sum / (parts * parts);
}

}  // namespace

float ggx_loss(float cosine, float alpha) {
  return at(tables::loss, Place(alpha, tables::loss_count),
            place_of_angle(cosine, alpha, tables::loss_count));
}

float average_ggx_loss(float alpha) { return at(tables::average_loss, Place(alpha, tables::loss_count)); }

GgxDielectricReflectance::GgxDielectricReflectance(float alpha, float ior) {
  const Place layer = place_of_ior(ior, tables::ior_count), y(std::sqrt(alpha), tables::alpha_count);
  static_assert(std::tuple_size_v<decltype(row_)> == tables::cosine_count);
  const auto entry = [&](int i, int x) {
    const auto& rows = tables::dielectric[i];
    return mix(rows[y.first][x], rows[y.first + 1][x], y.part);
  };
  for (int x = 0; x < tables::cosine_count; ++x)
    row_[std::size_t(x)] = mix(entry(layer.first, x), entry(layer.first + 1, x), layer.part);
  average_ = at(tables::average_dielectric, layer, y);
  if (ior > last_ior) integrate(alpha, ior);
}

void GgxDielectricReflectance::integrate(float alpha, float ior) {
  const Ggx facets(std::max(alpha, least_alpha));
  for (int x = 0; x < tables::cosine_count; ++x) {
    const float root = float(x) / (tables::cosine_count - 1);
    row_[std::size_t(x)] = reflected_part(facets, ior, std::max(root * root, 1e-3f));
  }
  constexpr int parts = 32;
  average_ = 0;
  for (int i = 0; i < parts; ++i) average_ += (*this)(std::sqrt((float(i) + 0.5f) / parts)) / parts;
}

float GgxDielectricReflectance::operator()(float cosine) const {
  return at(row_.data(), Place(std::sqrt(cosine), tables::cosine_count));
}

float ggx_boundary_loss(float cosine, float alpha, float eta) {
  const BoundaryPlace place(eta);
  const auto& layers = tables::boundary_loss[place.is_inside];
  const Place y(alpha, tables::boundary_count), x = place_of_angle(cosine, alpha, tables::boundary_count);
  return mix(at(layers[place.layer.first], y, x), at(layers[place.layer.first + 1], y, x), place.layer.part);
}

float average_ggx_boundary_loss(float alpha, float eta) {
  const BoundaryPlace place(eta);
  return at(tables::average_boundary_loss[place.is_inside], place.layer,
            Place(alpha, tables::boundary_count));
}

MultipleScattering::MultipleScattering(const Ggx& facets)
    : alpha_(facets.mean_alpha()), average_loss_(average_ggx_loss(alpha_)) {}

float MultipleScattering::evaluate(float cos_o, float cos_i) const {
  return average_loss_ > 0 ? loss(cos_o) * loss(cos_i) / (pi * average_loss_) : 0;
}

Rgb MultipleScattering::absorption(const Rgb& average) const {
  const auto channel = [&](float f) { return f * f * (1 - average_loss_) / (1 - f * average_loss_); };
  return {channel(average.r), channel(average.g), channel(average.b)};
}

DielectricMultipleScattering::DielectricMultipleScattering(const Ggx& facets, float eta)
    : alpha_(facets.mean_alpha()), eta_(eta) {
  const float here = average_ggx_boundary_loss(alpha_, eta),
              there = average_ggx_boundary_loss(alpha_, 1 / eta);
  // What a smooth boundary transmits of light from all directions: eta^2 times as much into the denser side.
  const float dense = eta < 1 ? 1 / eta : eta, in = 1 - GgxDielectricReflectance(0, dense).average();
  const float transmitted = eta < 1 ? in / (dense * dense) : in;
  // Reciprocity: the parts transmitted from both sides, over the other side's loss, are as eta^2 to 1.
  const float share = transmitted / std::max(here, there);
  reflected_ = 1 - share * there;
  reflected_scale_ = reflected_ / (pi * here);
  transmitted_scale_ = share / (pi * eta * eta);
}

float DielectricMultipleScattering::reflection(float cos_o, float cos_i) const {
  return reflected_scale_ * loss(cos_o) * loss(cos_i);
}

float DielectricMultipleScattering::transmission(float cos_o, float cos_i) const {
  return transmitted_scale_ * loss(cos_o) * ggx_boundary_loss(cos_i, alpha_, 1 / eta_);
}

}  // namespace twinray

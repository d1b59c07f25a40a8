// SPDX-License-Identifier: Apache-2.0
// The numbers are in core/ggx_albedo_tables.h; here they are interpolated.
#include "core/ggx_albedo.h"

#include "core/fresnel.h"
#include "core/ggx_albedo_tables.h"
#include "core/ggx_boundary_tables.h"
#include "core/ggx_directions.h"
#include "core/table_place.h"

namespace twinray {
namespace {

/// The rows of boundaries into the denser medium, or out of it, around an index.
struct BoundaryPlace {
  bool is_inside;
  TablePlace layer;

  explicit BoundaryPlace(float eta)
      : is_inside(eta < 1), layer(place_of_ior(eta < 1 ? 1 / eta : eta, tables::boundary_ior_count)) {}
};

/// A tabulated loss with a change, where that leaves [0, 1].
float part_of_light(float loss) { return loss > 0 ? std::min(loss, 1.0f) : 0; }

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
  return at(tables::loss, TablePlace(alpha, tables::loss_count),
            place_of_angle(cosine, alpha, tables::loss_count));
}

float average_ggx_loss(float alpha) {
  return at(tables::average_loss, TablePlace(alpha, tables::loss_count));
}

GgxDielectricReflectance::GgxDielectricReflectance(float alpha, float ior) {
  const TablePlace layer = place_of_ior(ior, tables::ior_count), y(std::sqrt(alpha), tables::alpha_count);
  static_assert(std::tuple_size_v<decltype(row_)> == tables::cosine_count);
  const auto entry = [&](int i, int x) {
    const auto& rows = tables::dielectric[i];
    return between(rows[y.first][x], rows[y.first + 1][x], y.part);
  };
  for (int x = 0; x < tables::cosine_count; ++x)
    row_[std::size_t(x)] = between(entry(layer.first, x), entry(layer.first + 1, x), layer.part);
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
  return at(row_.data(), TablePlace(std::sqrt(cosine), tables::cosine_count));
}

float ggx_boundary_loss(float cosine, float alpha, float eta) {
  const BoundaryPlace place(eta);
  const auto& layers = tables::boundary_loss[place.is_inside];
  const TablePlace y(alpha, tables::boundary_count),
      x = place_of_angle(cosine, alpha, tables::boundary_count);
  return between(at(layers[place.layer.first], y, x), at(layers[place.layer.first + 1], y, x),
                 place.layer.part);
}

float average_ggx_boundary_loss(float alpha, float eta) {
  const BoundaryPlace place(eta);
  return at(tables::average_boundary_loss[place.is_inside], place.layer,
            TablePlace(alpha, tables::boundary_count));
}

MultipleScattering::MultipleScattering(const Ggx& facets)
    : facets_(facets), alpha_(facets.mean_alpha()), average_loss_(average_ggx_loss(alpha_)) {
  if (!facets.has_one_alpha()) average_loss_ = part_of_light(average_loss_ + average_ggx_loss_change(facets));
}

float MultipleScattering::loss(const Vec3& w) const {
  const float loss = ggx_loss(w.z, alpha_);
  return facets_.has_one_alpha() ? loss : part_of_light(loss + ggx_loss_change(facets_, w));
}

float MultipleScattering::evaluate(const Vec3& wo, const Vec3& wi) const {
  return average_loss_ > 0 ? loss(wo) * loss(wi) / (pi * average_loss_) : 0;
}

Rgb MultipleScattering::absorption(const Rgb& average) const {
  const auto channel = [&](float f) { return f * f * (1 - average_loss_) / (1 - f * average_loss_); };
  return {channel(average.r), channel(average.g), channel(average.b)};
}

DielectricMultipleScattering::DielectricMultipleScattering(const Ggx& facets, float eta)
    : facets_(facets), alpha_(facets.mean_alpha()), eta_(eta) {
  const float here = average_loss(eta), there = average_loss(1 / eta);
  // What a smooth boundary transmits of light from all directions: eta^2 times as much into the denser side.
  const float dense = eta < 1 ? 1 / eta : eta, in = 1 - GgxDielectricReflectance(0, dense).average();
  const float transmitted = eta < 1 ? in / (dense * dense) : in;
  // Reciprocity: the parts transmitted from both sides, over the other side's loss, are as eta^2 to 1.
  const float share = transmitted / std::max(here, there);
  reflected_ = 1 - share * there;
  reflected_scale_ = reflected_ / (pi * here);
  transmitted_scale_ = share / (pi * eta * eta);
}

float DielectricMultipleScattering::average_loss(float eta) const {
  const float loss = average_ggx_boundary_loss(alpha_, eta);
  return facets_.has_one_alpha() ? loss
                                 : part_of_light(loss + average_ggx_boundary_loss_change(facets_, eta));
}

float DielectricMultipleScattering::loss(const Vec3& w, float eta) const {
  const float loss = ggx_boundary_loss(w.z, alpha_, eta);
  return facets_.has_one_alpha() ? loss : part_of_light(loss + ggx_boundary_loss_change(facets_, w, eta));
}

float DielectricMultipleScattering::reflection(const Vec3& wo, const Vec3& wi) const {
  return reflected_scale_ * loss(wo) * loss(wi);
}

float DielectricMultipleScattering::transmission(const Vec3& wo, const Vec3& wi) const {
  return transmitted_scale_ * loss(wo) * loss({wi.x, wi.y, -wi.z}, 1 / eta_);
}

}  // namespace twinray

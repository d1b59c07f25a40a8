// SPDX-License-Identifier: Apache-2.0
// The numbers are in core/ggx_albedo_tables.h; here they are interpolated.
#include "core/ggx_albedo.h"

#include "core/ggx_albedo_tables.h"
#include "core/ggx_boundary_tables.h"
#include "core/ggx_directions.h"
#include "core/ggx_high_index_tables.h"
#include "core/table_place.h"

namespace twinray {
namespace {

/// A tabulated loss with a change, where that leaves [0, 1].
float part_of_light(float loss) { return loss > 0 ? std::min(loss, 1.0f) : 0; }

/// Between which layers of the tables of reflectances an index lies.
class DielectricPlace {
 public:
  explicit DielectricPlace(float ior)
      : is_high_(ior > least_high_ior),
        layer_(is_high_ ? TablePlace(1 - std::sqrt(least_high_ior / ior), tables::high_ior_count + 1)
                        : TablePlace(root_of_ior(ior), tables::ior_count)) {}

  using Layer = float[tables::alpha_count][tables::cosine_count];
  const Layer& lower() const { return layer(layer_.first); }
  const Layer& upper() const { return layer(layer_.first + 1); }
  float part() const { return layer_.part; }
  /// Of light from all directions.
  float average(const TablePlace& row) const {
    return between(at(averages(layer_.first), row), at(averages(layer_.first + 1), row), layer_.part);
  }

 private:
  static constexpr float least_high_ior = 3;
  static constexpr int last =
      tables::ior_count - 1;  ///< The layer of that index, which is the first of high ones.

  const Layer& layer(int i) const {
    if (!is_high_) return tables::dielectric[i];
    return i == 0 ? tables::dielectric[last] : tables::high_dielectric[i - 1];
  }
  const float* averages(int i) const {
    if (!is_high_) return tables::average_dielectric[i];
    return i == 0 ? tables::average_dielectric[last] : tables::average_high_dielectric[i - 1];
  }

  bool is_high_;
  TablePlace layer_;
};

TablePlace row_of(float alpha) { return {std::sqrt(alpha), tables::alpha_count}; }

}  // namespace

float ggx_loss(float cosine, float alpha) {
  return at(tables::loss, TablePlace(alpha, tables::loss_count),
            place_of_angle(cosine, alpha, tables::loss_count));
}

float average_ggx_loss(float alpha) {
  return at(tables::average_loss, TablePlace(alpha, tables::loss_count));
}

GgxDielectricReflectance::GgxDielectricReflectance(float alpha, float ior) {
  static_assert(std::tuple_size_v<decltype(row_)> == tables::cosine_count);
  const DielectricPlace place(ior);
  const TablePlace y = row_of(alpha);
  const auto entry = [&](const auto& rows, int x) {
    return between(rows[y.first][x], rows[y.first + 1][x], y.part);
  };
  for (int x = 0; x < tables::cosine_count; ++x)
    row_[std::size_t(x)] = between(entry(place.lower(), x), entry(place.upper(), x), place.part());
  average_ = place.average(y);
}

float ggx_dielectric_reflectance(float cosine, float alpha, float ior) {
  const DielectricPlace place(ior);
  const TablePlace y = row_of(alpha), x(std::sqrt(cosine), tables::cosine_count);
  return between(at(place.lower(), y, x), at(place.upper(), y, x), place.part());
}

float GgxDielectricReflectance::operator()(float cosine) const {
  return at(row_.data(), TablePlace(std::sqrt(cosine), tables::cosine_count));
}

float ggx_boundary_loss(float cosine, float alpha, float eta) {
  const BoundaryPlace place(eta, tables::boundary_ior_count);
  const auto& layers = tables::boundary_loss[place.is_out];
  const TablePlace y(alpha, tables::boundary_count),
      x = place_of_angle(cosine, alpha, tables::boundary_count);
  return between(at(layers[place.layer.first], y, x), at(layers[place.layer.first + 1], y, x),
                 place.layer.part);
}

float average_ggx_boundary_loss(float alpha, float eta) {
  const BoundaryPlace place(eta, tables::boundary_ior_count);
  return at(tables::average_boundary_loss[place.is_out], place.layer,
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

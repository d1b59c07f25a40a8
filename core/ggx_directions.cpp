// SPDX-License-Identifier: Apache-2.0
// The numbers are in core/ggx_direction_tables.h; here they are interpolated.
#include "core/ggx_directions.h"

#include "core/ggx_direction_tables.h"
#include "core/table_place.h"

namespace twinray {
namespace {

template <int rows, int count>
float change(const float (*table)[rows][count], const TablePlace& alpha, const Azimuth& azimuth,
             const TablePlace& angle) {
  static_assert(rows == tables::share_count + 1);
  const float *skew0 = table[alpha.first][rows - 1], *skew1 = table[alpha.first + 1][rows - 1];
  return at(table, alpha, TablePlace(azimuth.share, tables::share_count), angle) +
         between(at(skew0, angle), at(skew1, angle), alpha.part) * azimuth.skew2;
}

TablePlace place_of_axes(const Ggx& facets) {
  const float x = facets.alpha_x(), y = facets.alpha_y();
  return {2 * std::min(x, y) / (x + y), tables::share_count};
}

}  // namespace

float ggx_loss_change(const Ggx& facets, const Vec3& w) {
  const float alpha = facets.mean_alpha();
  return change(tables::loss_change, TablePlace(alpha, tables::change_alpha_count), facets.azimuth(w),
                place_of_angle(w.z, alpha, tables::change_angle_count));
}

float average_ggx_loss_change(const Ggx& facets) {
  return at(tables::average_loss_change, TablePlace(facets.mean_alpha(), tables::change_alpha_count),
            place_of_axes(facets));
}

float ggx_boundary_loss_change(const Ggx& facets, const Vec3& w, float eta) {
  const BoundaryPlace place(eta, tables::boundary_change_ior_count);
  const auto& layers = tables::boundary_loss_change[place.is_out];
  const float alpha = facets.mean_alpha();
  const TablePlace of_alpha(alpha, tables::boundary_change_alpha_count),
      angle = place_of_angle(w.z, alpha, tables::boundary_change_angle_count);
  const Azimuth azimuth = facets.azimuth(w);
  return between(change(layers[place.layer.first], of_alpha, azimuth, angle),
                 change(layers[place.layer.first + 1], of_alpha, azimuth, angle), place.layer.part);
}

float average_ggx_boundary_loss_change(const Ggx& facets, float eta) {
  const BoundaryPlace place(eta, tables::boundary_change_ior_count);
  return at(tables::average_boundary_loss_change[place.is_out], place.layer,
            TablePlace(facets.mean_alpha(), tables::boundary_change_alpha_count), place_of_axes(facets));
}

}  // namespace twinray

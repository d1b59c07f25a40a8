// SPDX-License-Identifier: Apache-2.0
#include "integrators/wave/lobe_surfaces.h"

namespace twinray {

void LobeSurfaces::add(std::size_t index, const Interaction& at, float x, float y) {
  const std::size_t i = size++;
  surface[i] = std::uint32_t(index);
  tangent.set(i, at.frame().tangent);
  bitangent.set(i, at.frame().bitangent);
  normal.set(i, at.frame().normal);
  wo.set(i, at.wo_local());
  alpha_x[i] = x;
  alpha_y[i] = y;
}

void CoatedDiffuseSurfaces::clear() {
  size = 0;
  rows.clear();
}

void CoatedDiffuseSurfaces::add(std::size_t index, const Interaction& at, const CoatedDiffuseLobe& lobe) {
  const Coat& coat = lobe.coat();
  const std::size_t i = size;
  ior[i] = coat.ior();
  average[i] = coat.average_reflectance();
  base.set(i, lobe.base());
  const auto& its_row = coat.rough_reflectance().row();
  if (rows.empty() || rows.back() != its_row) rows.push_back(its_row);
  row[i] = std::uint32_t((rows.size() - 1) * its_row.size());
  const Ggx& facets = coat.facets();
  LobeSurfaces::add(index, at, coat.is_smooth() ? 0 : facets.alpha_x(),
                    coat.is_smooth() ? 0 : facets.alpha_y());
}

void RoughConductorSurfaces::add(std::size_t index, const Interaction& at, const RoughConductorLobe& lobe) {
  const std::size_t i = size;
  eta.set(i, lobe.eta());
  k.set(i, lobe.k());
  reflectance.set(i, lobe.reflectance());
  multiple_factor.set(i, lobe.multiple_factor());
  loss_alpha[i] = lobe.multiple().alpha();
  average_loss[i] = lobe.multiple().average_loss();
  most_once[i] = max_component(lobe.average_fresnel());
  most_multiple[i] = max_component(lobe.multiple_factor());
  LobeSurfaces::add(index, at, lobe.facets().alpha_x(), lobe.facets().alpha_y());
}

}  // namespace twinray

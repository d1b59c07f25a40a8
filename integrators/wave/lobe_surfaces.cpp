// SPDX-License-Identifier: Apache-2.0
#include "integrators/wave/lobe_surfaces.h"

namespace twinray {

void LobeSurfaces::clear() {
  size = 0;
  has_maps = false;
}

void LobeSurfaces::add(std::size_t index, const Interaction& at) {
  const std::size_t i = size++;
  surface[i] = std::uint32_t(index);
  tangent.set(i, at.frame().tangent);
  bitangent.set(i, at.frame().bitangent);
  normal.set(i, at.frame().normal);
  wo.set(i, at.wo_local());
  terminator[i] = at.terminator_alpha_squared();
  has_maps = has_maps || at.is_mapped();
}

void LambertSurfaces::add(std::size_t index, const Interaction& at, const LambertLobe& lobe) {
  reflectance.set(size, lobe.reflectance);
  LobeSurfaces::add(index, at);
}

void FacetColumns::set(std::size_t i, const Ggx& facets) {
  x[i] = facets.alpha_x();
  y[i] = facets.alpha_y();
}

void CoatColumns::set(std::size_t i, const Coat& coat) {
  facets.set(i, coat.facets());
  if (coat.is_smooth()) facets.x[i] = facets.y[i] = 0;
  ior[i] = coat.ior();
  const auto& its_row = coat.rough_reflectance().row();
  if (rows.empty() || rows.back() != its_row) rows.push_back(its_row);
  row[i] = std::uint32_t((rows.size() - 1) * its_row.size());
}

void CoatedDiffuseSurfaces::clear() {
  LobeSurfaces::clear();
  coat.rows.clear();
}

void CoatedDiffuseSurfaces::add(std::size_t index, const Interaction& at, const CoatedDiffuseLobe& lobe) {
  coat.set(size, lobe.coat());
  average[size] = lobe.coat().average_reflectance();
  base.set(size, lobe.base());
  LobeSurfaces::add(index, at);
}

void MultipleColumns::set(std::size_t i, const MultipleScattering& multiple, const Rgb& its_factor) {
  alpha[i] = multiple.alpha();
  average_loss[i] = multiple.average_loss();
  factor.set(i, its_factor);
}

void RoughConductorSurfaces::add(std::size_t index, const Interaction& at, const RoughConductorLobe& lobe) {
  const std::size_t i = size;
  facets.set(i, lobe.facets());
  eta.set(i, lobe.eta());
  k.set(i, lobe.k());
  reflectance.set(i, lobe.reflectance());
  multiple.set(i, lobe.multiple(), lobe.multiple_factor());
  most_once[i] = max_component(lobe.average_fresnel());
  most_multiple[i] = max_component(lobe.multiple_factor());
  LobeSurfaces::add(index, at);
}

void PrincipledSurfaces::clear() {
  LobeSurfaces::clear();
  gloss.rows.clear();
}

void PrincipledSurfaces::add(std::size_t index, const Interaction& at, const BarePrincipled& base) {
  const std::size_t i = size;
  metal[i] = base.metal;
  opaque[i] = base.opaque;
  metal_normal.set(i, base.metal_fresnel.normal());
  metal_dip.set(i, base.metal_fresnel.dip());
  multiple.set(i, base.multiple, base.metal_multiple);
  gloss.set(i, base.gloss);
  specular_color.set(i, base.specular_color);
  diffuse.set(i, base.diffuse);
  roughness[i] = base.rough.roughness();
  scale[i] = base.rough.scale();
  average[i] = base.rough.average();
  several[i] = base.rough.multiple().r;
  LobeSurfaces::add(index, at);
}

}  // namespace twinray

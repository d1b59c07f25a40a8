// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/material.h"
#include "io/losses.h"

namespace twinray {

/// What pbrt has in place of a material: one whose model is Lambert, Dielectric, Conductor,
/// DiffuseTransmission, CoatedDiffuse, CoatedConductor, Interface or Mix, without factors that pbrt has not.
/// What differs is named. Light below a surface is that of a CoatedDiffuse, of all that its base reflects. A
/// texture of a roughness keeps the meaning of its model: see `squares_roughness`.
struct PbrtStandIn {
  Material material;
  bool squares_roughness = false;  ///< The textures' roughness is the root of alpha, as OpenPBR has it.
  Roughness facet_factors{1, 1};   ///< Of such a texture's alpha along the tangent and across.
  float base_weight = 1;           ///< A factor of the texture of what is reflected.
};
PbrtStandIn pbrt_stand_in(const Material& material, Losses& losses);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/scene.h"
#include "io/losses.h"

namespace twinray {

/// What glTF has in place of a material: one of OpenPBR whose numbers glTF can say (io/gltf/layers.h reads
/// them). What differs is named.
struct GltfStandIn {
  Material material;  ///< Its model is Principled, whose base_weight is a factor of a texture of its color.
  /// Its textures of roughnesses, to this power, are OpenPBR's: 1/2 of those of alpha.
  float roughness_power = 1;
};
/// `material`: index into the scene's.
GltfStandIn gltf_stand_in(const Scene& scene, std::uint32_t material, Losses& losses);

}  // namespace twinray

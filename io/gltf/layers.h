// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "io/gltf/inputs.h"

namespace tinygltf {
struct Material;
}

namespace twinray {

/// Whether a coat changes the index that an opaque surface has to what is above it, everywhere alike.
inline bool has_even_coat(const Material& material, const Principled& model) {
  return model.coat_weight > 0 && model.transmission_weight == 0 &&
         !texture_use(material, MaterialInput::coat_weight);
}
/// The index of refraction above the base, as OpenPBR has it.
inline float above_base(const Principled& model) { return 1 + (model.coat_ior - 1) * model.coat_weight; }

/// The metallic-roughness model's predecessor, which some files still have in its place.
inline constexpr const char* glossiness_extension = "KHR_materials_pbrSpecularGlossiness";

/// Adds what the extensions KHR_materials_* say of a surface: refraction, transmission, volume, coat, sheen,
/// specular reflection and anisotropy. Its base must have been read.
void read_layers(const tinygltf::Material& source, const std::string& pointer, GltfInputs& inputs);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "io/gltf/inputs.h"

namespace tinygltf {
struct Material;
}

namespace twinray {

/// The metallic-roughness model's predecessor, which some files still have in its place.
inline constexpr const char* glossiness_extension = "KHR_materials_pbrSpecularGlossiness";

/// Adds what the extensions KHR_materials_* say of a surface: refraction, transmission, volume, coat, sheen,
/// specular reflection and anisotropy. Its base must have been read.
void read_layers(const tinygltf::Material& source, const std::string& pointer, GltfInputs& inputs);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Meshes that KHR_draco_mesh_compression packs.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "io/gltf/accessor.h"

namespace tinygltf {
struct Primitive;
}

namespace twinray {

inline constexpr const char* draco_extension = "KHR_draco_mesh_compression";

/// A mesh as Draco gives it: the accessors of its primitive have no data of their own.
struct DracoMesh {
  std::vector<std::uint32_t> indices;  ///< Three a triangle.
  std::map<std::string, GltfNumbers> attributes;
};

/// Decodes the mesh of a primitive. Throws Error, with the place, where the data are damaged or do not hold
/// what the extension says.
DracoMesh decode_draco(GltfDocument& document, const tinygltf::Primitive& primitive,
                       const std::string& pointer);

}  // namespace twinray

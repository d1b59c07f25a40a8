// SPDX-License-Identifier: Apache-2.0
// The materials of a glTF file as surfaces of OpenPBR. What becomes of each property: docs/gltf.md.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/light.h"
#include "core/material.h"
#include "io/gltf/texture.h"

namespace twinray {

class GltfDocument;

/// What a shape of a material has.
struct GltfSurface {
  std::uint32_t material = 0;        ///< Index into GltfMaterials::materials.
  std::uint32_t alpha = no_texture;  ///< Index into the textures: it cuts holes.
  MeshLight glow;                    ///< But for its shape.
};

/// What a primitive has that its material's textures go by.
struct GltfUse {
  bool has_uvs = false;              ///< Texture coordinates of the set that uv_set() says.
  bool has_second_uvs = false;       ///< Those that second_uv_set() says, too.
  bool is_mirrored = false;          ///< They run the other way round, as tangents say.
  std::uint32_t color = no_texture;  ///< Of the vertices, times which the base color is.
  std::uint32_t alpha = no_texture;  ///< Of the vertices.
  std::vector<int> missing_sets;     ///< Of uv_sets() those of which the primitive has no coordinates.

  auto operator<=>(const GltfUse&) const = default;
};

class GltfMaterials {
 public:
  explicit GltfMaterials(GltfDocument& document) : textures(document), document_(document) {}

  /// The number of the set of texture coordinates that a material's textures go by: that of its base color,
  /// if it has a picture, else of the first one that has; the first set where it has none, but facets of a
  /// direction; else none.
  std::optional<int> uv_set(int material) const;
  /// The next other set by which its colors and numbers go.
  std::optional<int> second_uv_set(int material) const;
  /// The numbers of all sets that its textures name.
  std::set<int> uv_sets(int material) const;
  /// Whether it has a normal map or a tangent, which are not the same for both ways round of texture
  /// coordinates.
  bool needs_handedness(int material) const;
  /// Whether it looks otherwise where tangents point elsewhere.
  bool goes_by_tangents(int material) const;
  bool is_unlit(int material) const;
  /// The same material for each of the same uses. -1: the format's default material.
  const GltfSurface& surface(int material, const GltfUse& use);

  std::vector<Material> materials;
  GltfTextures textures;
  std::vector<std::string> occluded = {};  ///< Names of materials whose occlusion is left out.

 private:
  GltfDocument& document_;
  std::map<std::pair<int, GltfUse>, GltfSurface> known_;
};

/// "/materials/3"
std::string material_pointer(int material);

}  // namespace twinray

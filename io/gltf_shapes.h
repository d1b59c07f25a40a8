// SPDX-License-Identifier: Apache-2.0
// The shapes of a scene that is read from a glTF file: primitives where nodes put them, with what they are
// made of.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/gltf_colors.h"
#include "io/gltf_deform.h"
#include "io/gltf_document.h"
#include "io/gltf_material.h"
#include "io/gltf_primitive.h"
#include "io/scene_part.h"

namespace twinray {

class GltfShapes {
 public:
  GltfShapes(GltfDocument& document, GltfMaterials& materials)
      : document_(document), materials_(materials), colors_(materials.textures, document.context()) {}

  /// Adds the primitives of a node's mesh, once for each transform, its vertices moved.
  void add(int node, const std::vector<Transform>& to_world, const GltfDeformation& deformation);

  std::vector<ScenePart> parts;
  std::vector<std::string> assets;
  std::size_t dropped_triangles = 0, replaced_normals = 0;

  static constexpr std::size_t max_triangles = std::size_t(1) << 28;

 private:
  const std::optional<GltfPrimitive>& primitive(int mesh, int index);
  void place(const GltfPrimitive& primitive, const std::string& name, const Transform& to_world);
  /// The triangles whose texture coordinates run this way round, with what the primitive's surface needs.
  void place_part(const GltfPrimitive& primitive, Mesh mesh, GltfUse use, const Transform& to_world);
  /// What a part emits, by its surface.
  void add_emission(const GltfSurface& surface, const std::string& pointer, Mesh& mesh, ScenePart& part);
  void check_room(const GltfPrimitive& primitive);

  GltfDocument& document_;
  GltfMaterials& materials_;
  GltfColors colors_;
  std::map<std::pair<int, int>, std::optional<GltfPrimitive>> primitives_;
  std::size_t triangles_ = 0, vertices_ = 0;
};

}  // namespace twinray

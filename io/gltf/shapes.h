// SPDX-License-Identifier: Apache-2.0
// The shapes of a scene that is read from a glTF file: primitives where nodes put them, with what they are
// made of.
#pragma once
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "io/gltf/colors.h"
#include "io/gltf/deform.h"
#include "io/gltf/document.h"
#include "io/gltf/material.h"
#include "io/gltf/primitive.h"
#include "io/scene_part.h"

namespace twinray {

class GltfShapes {
 public:
  GltfShapes(GltfDocument& document, GltfMaterials& materials)
      : document_(document), materials_(materials), colors_(materials.textures, document.context()) {}

  /// Adds the primitives of a node's mesh, once for each transform, its vertices moved.
  void add(int node, const std::vector<Transform>& to_world, const GltfDeformation& deformation);
  /// Makes instances or copies of what has been added, when all has been.
  void place_all();

  std::vector<ScenePart> parts;
  std::vector<Instance> instances;  ///< Of the parts' prototypes.
  std::vector<std::string> assets;
  std::size_t dropped_triangles = 0, replaced_normals = 0;
  std::size_t repeated = 0;  ///< Meshes that are shown more than once, and could be instances.

  static constexpr std::size_t max_triangles = std::size_t(1) << 28;

 private:
  /// A node that shows a mesh.
  struct Shown {
    int node, mesh;
    std::uint32_t asset;
    std::vector<Transform> to_world;
    GltfDeformation deformation;
  };
  /// Parts of a mesh: those that emit are copied where the others are instances.
  enum class Which { all, glowing, dark };
  /// A primitive as it is placed.
  struct Place {
    const Transform& to_world;
    std::uint32_t asset;
    bool is_mirrored;  ///< Where it is seen; to_world may be the way to a prototype.
    Which which = Which::all;
    std::optional<std::uint32_t> prototype = {};
  };
  /// What instances of a mesh share.
  struct Prototype {
    std::uint32_t number;
    Aabb box;      ///< Of its parts; empty where all of them emit.
    bool is_dark;  ///< No part emits.
  };

  const std::optional<GltfPrimitive>& primitive(int mesh, int index);
  std::size_t triangles_of(int mesh);
  /// The meshes that are stored once.
  std::set<int> shared_meshes();
  void place_mesh_of(const Shown& shown, const Place& place);
  const Prototype& prototype_of(const Shown& shown, bool is_mirrored);
  /// An instance of the mesh; of what cannot be one, a copy.
  void place_instance(const Shown& shown, const Transform& to_world);
  void place(const GltfPrimitive& primitive, const std::string& name, const Place& place);
  /// The triangles whose texture coordinates run this way round, with what the primitive's surface needs.
  void place_part(const GltfPrimitive& primitive, Mesh mesh, GltfUse use, const Place& place);

  void check_room(const Mesh& mesh, const std::string& pointer);

  GltfDocument& document_;
  GltfMaterials& materials_;
  GltfColors colors_;
  std::map<std::pair<int, int>, std::optional<GltfPrimitive>> primitives_;
  std::vector<Shown> shown_;
  std::map<std::pair<int, bool>, Prototype> prototypes_;  ///< By mesh, and whether it is seen mirrored.
  std::size_t triangles_ = 0, vertices_ = 0;
  std::size_t left_out_ = 0;  ///< Parts that are not among those that were to be placed.
};

}  // namespace twinray

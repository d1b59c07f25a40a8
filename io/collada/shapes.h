// SPDX-License-Identifier: Apache-2.0
// The shapes of a COLLADA scene: what its nodes instance, in its place, with what it is made of.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/collada/geometry.h"
#include "io/collada/material.h"
#include "io/collada/parts.h"

namespace twinray {

class ColladaShapes {
 public:
  ColladaShapes(ColladaDocument& document, ColladaMaterials& materials, SceneParts& parts)
      : document_(document), materials_(materials), parts_(parts) {}

  /// Shows what a <geometry> holds, as `instance` has it. The shape belongs to the last of the assets.
  void show(const XmlElement& instance, const XmlElement& geometry,
            std::shared_ptr<const ColladaGeometry> shape, const std::string& name, const Transform& to_world);
  /// Makes copies or instances of all that is shown, when all of it is known. Throws Error for more than
  /// max_triangles.
  void place_all();

  std::size_t dropped_triangles = 0;
  std::size_t repeated = 0;  ///< Shapes that are shown more than once, and could be instances.

  static constexpr std::size_t max_triangles = std::size_t(1) << 28;

 private:
  /// A shape at a place, and what its parts are made of.
  struct Shown {
    XmlElement instance;
    std::shared_ptr<const ColladaGeometry> shape;
    std::string name;
    std::uint32_t asset;
    Transform to_world;
    std::vector<ColladaBinding> bindings;
  };
  /// What instances have in common: a shape, and for each part a material and a set of texture coordinates.
  using Key = std::pair<const ColladaGeometry*, std::vector<std::pair<std::uint32_t, std::uint32_t>>>;
  struct Prototype {
    std::uint32_t number;
    Aabb box;  ///< Of what does not emit; empty where all of it does.
  };

  bool is_cs184() const { return document_.options().interpretation == Interpretation::cs184; }
  static Key key_of(const Shown& shown);
  /// Whether it may be one of many instances.
  bool can_be_shared(const Shown& shown) const;
  void place(const Shown& shown);
  void place_instance(const Shown& shown);
  /// What it shares with others like it: made where it is seen first.
  const Prototype& prototype_of(const Shown& shown);
  void add_sphere(const Shown& shown);
  /// A part of the shape: in the scene, or of a prototype.
  void add_part(const Shown& shown, std::size_t index, const Transform& to_world,
                std::optional<std::uint32_t> prototype = {});
  const Mesh& mesh_with_uvs(const ColladaPart& part, const ColladaBinding& binding, Mesh& made);

  ColladaDocument& document_;
  ColladaMaterials& materials_;
  SceneParts& parts_;
  std::vector<Shown> shown_;
  std::map<Key, Prototype> prototypes_;
  std::size_t triangles_ = 0;
};

}  // namespace twinray

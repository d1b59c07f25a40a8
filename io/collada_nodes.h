// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/collada_cameras.h"
#include "io/collada_controller.h"
#include "io/collada_geometry.h"
#include "io/collada_layers.h"
#include "io/collada_material.h"
#include "io/collada_parts.h"

namespace twinray {

/// Walks the nodes of a visual scene and gathers what they instance, in world space.
class ColladaNodes {
 public:
  ColladaNodes(ColladaDocument& document, ColladaMaterials& materials)
      : document_(document), materials_(materials) {}

  /// The nodes must have passed check_node_tree(). Throws Error for references that lead nowhere, and for
  /// more than max_triangles.
  void walk(const XmlElement& visual_scene, const Transform& to_world);

  static constexpr std::size_t max_triangles = std::size_t(1) << 28;

  SceneParts parts;
  std::vector<ColladaCamera> cameras;
  std::vector<std::string> hidden;  ///< Names of the nodes whose lights or shapes the file hides.
  std::size_t dropped_triangles = 0;
  std::vector<std::string> without_attenuation;  ///< Point and spot lights that physics makes fall off.

 private:
  /// Where something is placed: its coordinates to the world's, and in which unit and axes they are.
  struct Placement {
    Transform to_world;
    ColladaSpace space;
  };

  /// `from` holds or instances the node.
  void visit(const XmlElement& node, const XmlElement& from, const Placement& outside);
  /// What counts of a node by CS184's rules: the nodes below it first, then one object.
  std::vector<XmlElement> cs184_children(const XmlElement& node);
  bool is_cs184() const { return document_.options().interpretation == Interpretation::cs184; }
  std::uint32_t current_asset() const { return std::uint32_t(parts.assets.size()) - 1; }
  bool names_nothing(const XmlElement& instance);
  void instance(const XmlElement& node, const XmlElement& child, const Placement& placement);
  void add_geometry(const XmlElement& node, const XmlElement& instance, const Placement& placement);
  void add_controller(const XmlElement& node, const XmlElement& instance, const Placement& placement);
  void add_shape(const XmlElement& node, const XmlElement& instance, const XmlElement& element,
                 const ColladaGeometry& shape, const Transform& to_world);
  void add_part(const ColladaPart& part, const std::string& name, const XmlElement& instance,
                const Transform& to_world);
  void add_sphere(float radius, const std::string& name, const XmlElement& instance,
                  const Transform& to_world);
  void add_light(const XmlElement& instance, const Transform& to_world);
  void add_camera(const XmlElement& node, const XmlElement& instance, const Placement& placement);
  const ColladaGeometry& geometry(const XmlElement& element);

  ColladaDocument& document_;
  ColladaMaterials& materials_;
  SceneLayers layers_;
  std::optional<ColladaControllers> controllers_;  ///< Of the scene that is walked.
  std::map<XmlElement, ColladaGeometry> geometries_;
  int hiding_ = 0;  ///< How many of the nodes from the root to the one being visited hide what is below.
  std::size_t triangles_ = 0;
};

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/collada/cameras.h"
#include "io/collada/controller.h"

#include "io/collada/layers.h"

#include "io/collada/parts.h"
#include "io/collada/shapes.h"

namespace twinray {

/// Walks the nodes of a visual scene and gathers what they instance, in world space.
class ColladaNodes {
 public:
  ColladaNodes(ColladaDocument& document, ColladaMaterials& materials)
      : document_(document), shapes_(document, materials, parts) {}
  ColladaNodes(const ColladaNodes&) = delete;

  /// The nodes must have passed check_node_tree(). Throws Error for references that lead nowhere, and as
  /// ColladaShapes does.
  void walk(const XmlElement& visual_scene, const Transform& to_world);

  std::size_t dropped_triangles() const { return shapes_.dropped_triangles; }
  std::size_t repeated() const { return shapes_.repeated; }

  SceneParts parts;
  std::vector<ColladaCamera> cameras;
  std::vector<std::string> hidden;  ///< Names of the nodes whose lights or shapes the file hides.

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

  bool names_nothing(const XmlElement& instance);
  void instance(const XmlElement& node, const XmlElement& child, const Placement& placement);
  void add_geometry(const XmlElement& node, const XmlElement& instance, const Placement& placement);
  void add_controller(const XmlElement& node, const XmlElement& instance, const Placement& placement);

  void add_light(const XmlElement& instance, const Transform& to_world);
  void add_camera(const XmlElement& node, const XmlElement& instance, const Placement& placement);
  std::shared_ptr<const ColladaGeometry> geometry(const XmlElement& element);

  ColladaDocument& document_;
  ColladaShapes shapes_;
  SceneLayers layers_;
  std::optional<ColladaControllers> controllers_;  ///< Of the scene that is walked.
  std::map<XmlElement, std::shared_ptr<const ColladaGeometry>> geometries_;
  int hiding_ = 0;  ///< How many of the nodes from the root to the one being visited hide what is below.
};

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Controllers change the vertices of a geometry: a skin by the joints of the scene, a morph by those of other
// geometries, its targets. Each may be the source of another one. They are read as they stand in the file;
// what an animation makes of joints and weights is not.
#pragma once
#include <optional>
#include <vector>

#include "core/transform.h"
#include "io/collada/joints.h"
#include "io/collada/morph.h"

namespace twinray {

/// A geometry as controllers leave it.
struct PosedGeometry {
  XmlElement geometry;
  ControlledShape shape;  ///< Its vertices only where a controller has used them.
  Transform to_node;      ///< The shape's coordinates to those of the node: a skin's bind shape.
  bool is_in_scene =
      false;  ///< Joints have brought the shape to the coordinates of the scene; its node moves it still.
};

/// The controllers of a scene.
class ColladaControllers {
 public:
  ColladaControllers(const XmlElement& visual_scene, ColladaDocument& document)
      : visual_scene_(visual_scene), document_(document) {}

  /// What an <instance_controller> shows, with a warning for each of its controllers. Where one cannot be
  /// followed, since numbers or joints are missing, the warning says why: a skin then stands in its bind
  /// pose, and a morph is its base mesh. Throws Error for sources that form a circle, or lead nowhere.
  PosedGeometry pose(const XmlElement& instance);

 private:
  PosedGeometry pose_of(const XmlElement& element);
  void apply_skin(PosedGeometry& pose, const XmlElement& skin);
  void apply_morph(PosedGeometry& pose, const XmlElement& morph);
  void read_vertices_of(PosedGeometry& pose);

  XmlElement visual_scene_;
  ColladaDocument& document_;
  std::optional<ColladaJoints> joints_;
  std::optional<XmlElement> instance_;
  std::vector<XmlElement>
      chain_;                 ///< The controllers that are being followed, each the source of the former.
  std::size_t followed_ = 0;  ///< Of this instance.
};

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// The joints that move a skin are nodes of the scene, which an <instance_controller> finds by their names.
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/transform.h"
#include "io/collada/document.h"

namespace twinray {

/// A node that may be a joint, where the scene's nodes place it.
struct ColladaJoint {
  XmlElement node;
  Transform to_scene;
  std::size_t end = 0;  ///< Of the walk over the scene's nodes: the index behind the last one below this one.
};

/// The nodes of a visual scene, and after them those of libraries, by the names that skins have for them.
class ColladaJoints {
 public:
  /// The scene's nodes must have passed check_node_tree().
  ColladaJoints(const XmlElement& visual_scene, ColladaDocument& document);

  /// The node with this sid: the first at or below the <skeleton>s of the instance, else the first of all.
  /// Without such a sid, the one with this id; a node that several <instance_node>s place is its first
  /// placement. Null where there is none.
  const ColladaJoint* named(std::string_view sid, const XmlElement& instance) const;
  const ColladaJoint* with_id(std::string_view id) const;

  /// Nodes beyond are no joints, with a warning; instances included.
  static constexpr std::size_t max_joints = 100'000;

 private:
  using Names = std::multimap<std::string, std::size_t, std::less<>>;

  /// `from` holds or instances the node.
  void visit(const XmlElement& node, const XmlElement& from, const Transform& parent,
             const ColladaSpace& outside);

  ColladaDocument& document_;
  std::vector<ColladaJoint> joints_;  ///< In the order of the walk.
  bool follows_instances_ = true;
  Names by_sid_, by_id_;  ///< Indices of joints_; those of one name in their order.
};

}  // namespace twinray

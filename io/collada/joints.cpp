// SPDX-License-Identifier: Apache-2.0
#include "io/collada/joints.h"

#include <fmt/format.h>

#include "io/collada/transform.h"

namespace twinray {

ColladaJoints::ColladaJoints(const XmlElement& visual_scene, ColladaDocument& document)
    : document_(document) {
  const ColladaSpace& space = document_.space_of(document_.root());
  for (const XmlElement& node : visual_scene.children("node")) visit(node, visual_scene, {}, space);
  follows_instances_ = false;
  for (const XmlElement& library : document_.root().children("library_nodes"))
    for (const XmlElement& node : library.children("node")) visit(node, library, {}, space);
}

void ColladaJoints::visit(const XmlElement& node, const XmlElement& from, const Transform& parent,
                          const ColladaSpace& outside) {
  const std::size_t index = joints_.size();
  if (index == max_joints)
    return document_.warn(node, fmt::format("of so many nodes the first {} may be joints", max_joints));
  const ColladaSpace& space = document_.space_of(node, from, outside);
  const Transform to_scene = parent * conversion(space, outside) * read_node_transform(node, document_);
  joints_.push_back({node, to_scene});
  if (const auto sid = node.attribute("sid")) by_sid_.emplace(*sid, index);
  if (const auto id = node.attribute("id")) by_id_.emplace(*id, index);
  for (const XmlElement& child : node.children()) {
    if (child.is("node")) visit(child, node, to_scene, space);
    if (follows_instances_ && child.is("instance_node") && !child.attribute("url").value_or("").empty())
      visit(document_.resolve(child, "url", "node"), child, to_scene, space);
  }
  joints_[index].end = joints_.size();
}

const ColladaJoint* ColladaJoints::named(std::string_view sid, const XmlElement& instance) const {
  const auto [begin, end] = by_sid_.equal_range(sid);
  if (begin == end) return with_id(sid);
  for (const XmlElement& skeleton : instance.children("skeleton")) {
    const std::string url = skeleton.text();
    const ColladaJoint* root = with_id(std::string_view(url).substr(url.find('#') + 1));
    if (!root) continue;
    const std::size_t first = std::size_t(root - joints_.data());
    for (auto each = begin; each != end; ++each)
      if (each->second >= first && each->second < root->end) return &joints_[each->second];
  }
  return &joints_[begin->second];
}

const ColladaJoint* ColladaJoints::with_id(std::string_view id) const {
  const auto found = by_id_.lower_bound(id);
  return found != by_id_.end() && found->first == id ? &joints_[found->second] : nullptr;
}

}  // namespace twinray

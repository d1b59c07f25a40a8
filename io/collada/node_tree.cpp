// SPDX-License-Identifier: Apache-2.0
// Each node is counted once, and what is below it remembered.
#include "io/collada/node_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

namespace twinray {
namespace {

struct Subtree {
  std::size_t nodes = 1, depth = 1;  ///< The node itself included; nodes up to one more than max_nodes.
};

class NodeCounter {
 public:
  explicit NodeCounter(ColladaDocument& document) : document_(document) {}

  /// What is at and below a node that has so many above it.
  Subtree count(const XmlElement& node, std::size_t above) {
    const auto [known, is_new] = subtrees_.try_emplace(node);
    if (!is_new && !known->second)
      node.fail("this node instances itself, by way of <instance_node>; nodes must form no circle");
    if (above + (is_new ? 1 : known->second->depth) > max_node_depth)
      node.fail(fmt::format("nodes are nested more than {} deep", max_node_depth));
    if (is_new) known->second = count_below(node, above);
    return *known->second;
  }

 private:
  Subtree count_below(const XmlElement& node, std::size_t above) {
    Subtree all;
    for (const XmlElement& child : node.children()) {
      if (!child.is("node") && !child.is("instance_node")) continue;
      const Subtree below =
          count(child.is("node") ? child : document_.resolve(child, "url", "node"), above + 1);
      all.nodes = std::min(all.nodes + below.nodes, max_nodes + 1);
      all.depth = std::max(all.depth, below.depth + 1);
    }
    return all;
  }

  ColladaDocument& document_;
  std::map<XmlElement, std::optional<Subtree>> subtrees_;  ///< Without a value while it is being counted.
};

}  // namespace

void check_node_tree(const XmlElement& visual_scene, ColladaDocument& document) {
  NodeCounter counter(document);
  std::size_t nodes = 0;
  for (const XmlElement& node : visual_scene.children("node")) {
    nodes += counter.count(node, 0).nodes;
    if (nodes > max_nodes)
      node.fail(fmt::format("the scene has more than {} nodes, instances included", max_nodes));
  }
}

}  // namespace twinray

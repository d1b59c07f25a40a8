// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>

#include "io/collada/document.h"

namespace twinray {

inline constexpr std::size_t max_node_depth = 200, max_nodes = std::size_t(1) << 22;

/// Throws Error for <instance_node>s in a circle, for more than max_node_depth nodes below each other, and
/// for more than max_nodes in all, instanced ones counted each time. It takes time and memory by what the
/// file holds, not by what it stands for: a chain of 40 nodes that instance the next one twice stands for
/// 2^40.
void check_node_tree(const XmlElement& visual_scene, ColladaDocument& document);

}  // namespace twinray

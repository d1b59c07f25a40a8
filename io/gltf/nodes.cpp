// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/nodes.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>

#include "core/quaternion.h"
#include "io/gltf/document.h"
#include "io/gltf/slot.h"

namespace twinray {
namespace {

constexpr int no_node = -1;

std::string node_pointer(int node) { return fmt::format("/nodes/{}", node); }

template <std::size_t n>
void assign(std::array<double, n>& target, const std::vector<double>& numbers) {
  if (numbers.size() == n) std::copy(numbers.begin(), numbers.end(), target.begin());
}

GltfPose rest_pose(GltfDocument& document, int index) {
  const tinygltf::Node& node = document.model().nodes[std::size_t(index)];
  GltfPose pose;
  assign(pose.translation, node.translation);
  assign(pose.rotation, node.rotation);
  assign(pose.scale, node.scale);
  warn_unless_rotation(pose.rotation, node_pointer(index) + "/rotation", document.context());
  if (!node.matrix.empty())
    pose.matrix = matrix_of(node.matrix, node_pointer(index) + "/matrix", document.context());
  pose.weights = node.weights;
  if (pose.weights.empty() && node.mesh >= 0)
    pose.weights = document.model().meshes[std::size_t(node.mesh)].weights;
  return pose;
}

std::vector<int> parents_of(GltfDocument& document) {
  const auto& nodes = document.model().nodes;
  std::vector<int> parents(nodes.size(), no_node);
  for (std::size_t node = 0; node < nodes.size(); ++node)
    for (const int child : nodes[node].children) {
      if (parents[std::size_t(child)] != no_node)
        document.context().fail(
            node_pointer(child),
            fmt::format("the node is a child of both node {} and node {}; nodes form trees",
                        parents[std::size_t(child)], node));
      parents[std::size_t(child)] = int(node);
    }
  return parents;
}

/// The nodes and all that is below them, parents first.
std::vector<int> with_descendants(const GltfDocument& document, std::vector<int> nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::vector<int>& children = document.model().nodes[std::size_t(nodes[i])].children;
    nodes.insert(nodes.end(), children.begin(), children.end());
  }
  return nodes;
}

std::vector<int> roots_of(const std::vector<int>& parents) {
  std::vector<int> roots;
  for (std::size_t node = 0; node < parents.size(); ++node)
    if (parents[node] == no_node) roots.push_back(int(node));
  return roots;
}

}  // namespace

Transform matrix_of(const std::vector<double>& m, const std::string& pointer, const GltfContext& context) {
  if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1)
    context.fail(pointer,
                 fmt::format("the last row is {} {} {} {}; it must be 0 0 0 1", m[3], m[7], m[11], m[15]));
  Transform t;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 4; ++column) t.m[row][column] = m[column * 4 + row];
  return t;
}

void warn_unless_rotation(const std::array<double, 4>& q, const std::string& pointer, GltfContext& context) {
  if (std::all_of(q.begin(), q.end(), [](double number) { return number == 0; }))
    context.warn(pointer, "0 0 0 0 is no rotation: nothing is turned by it");
}

Transform transform_of(const GltfPose& pose) {
  if (pose.matrix) return *pose.matrix;
  const auto& [tx, ty, tz] = pose.translation;
  const auto& [sx, sy, sz] = pose.scale;
  const auto& [x, y, z, w] = pose.rotation;
  return Transform::translation(tx, ty, tz) * rotation_of({x, y, z, w}) * Transform::scaling(sx, sy, sz);
}

std::vector<GltfPose> rest_poses(GltfDocument& document) {
  std::vector<GltfPose> poses;
  for (std::size_t node = 0; node < document.model().nodes.size(); ++node)
    poses.push_back(rest_pose(document, int(node)));
  return poses;
}

std::vector<Transform> world_transforms(GltfDocument& document, const std::vector<GltfPose>& poses) {
  const std::vector<int> parents = parents_of(document);
  const std::vector<int> order = with_descendants(document, roots_of(parents));
  std::vector<Transform> world(poses.size());
  std::vector<bool> is_placed(poses.size(), false);
  for (const int node : order) {
    const auto at = std::size_t(node);
    const Transform own = transform_of(poses[at]);
    world[at] = parents[at] == no_node ? own : world[std::size_t(parents[at])] * own;
    is_placed[at] = true;
  }
  for (std::size_t node = 0; node < poses.size(); ++node)
    if (!is_placed[node])
      document.context().fail(node_pointer(int(node)), "the node is its own ancestor; nodes form trees");
  return world;
}

std::vector<int> shown_nodes(GltfDocument& document) {
  const tinygltf::Model& model = document.model();
  if (model.scenes.empty()) {
    if (!model.nodes.empty()) document.context().warn("/", "the file has no scene; all its nodes are shown");
    return with_descendants(document, roots_of(parents_of(document)));
  }
  const int scene = std::max(model.defaultScene, 0);
  const std::vector<int> parents = parents_of(document);
  const std::vector<int>& roots = model.scenes[std::size_t(scene)].nodes;
  for (const int root : roots)
    if (parents[std::size_t(root)] != no_node)
      document.context().fail(
          fmt::format("/scenes/{}/nodes", scene),
          fmt::format("node {} is a child of node {}; a scene names nodes without a parent", root,
                      parents[std::size_t(root)]));
  if (model.scenes.size() > 1)
    document.context().notes.push_back(
        fmt::format("the file has {} scenes; this is number {}{}", model.scenes.size(), scene,
                    model.defaultScene < 0 ? ", since the file does not say which one is shown" : ""));
  return with_descendants(document, roots);
}

std::vector<bool> visible_nodes(GltfDocument& document) {
  const std::vector<int> parents = parents_of(document);
  std::vector<bool> are_visible(parents.size());
  for (const int node : with_descendants(document, roots_of(parents))) {
    const auto at = std::size_t(node);
    const GltfExtension own(document.model().nodes[at].extensions, "KHR_node_visibility", "");
    are_visible[at] =
        own.flag("visible", true) && (parents[at] == no_node || are_visible[std::size_t(parents[at])]);
  }
  return are_visible;
}

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// The nodes of a glTF file: where they are, and which of them a scene shows.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/transform.h"

namespace twinray {

class GltfDocument;
struct GltfContext;

/// What a node says of its place, within its parent.
struct GltfPose {
  std::array<double, 3> translation{0, 0, 0};
  std::array<double, 4> rotation{0, 0, 0, 1};  ///< A quaternion x, y, z, w of any length but 0.
  std::array<double, 3> scale{1, 1, 1};
  std::optional<Transform> matrix;  ///< In place of the three.
  std::vector<double> weights;      ///< Of its mesh's morph targets.
};

/// From the node's space to its parent's: translation, rotation and scale, or the matrix.
Transform transform_of(const GltfPose& pose);

/// Sixteen numbers, column by column. Throws Error, with this place, unless the last row is 0 0 0 1.
Transform matrix_of(const std::vector<double>& numbers, const std::string& pointer,
                    const GltfContext& context);

/// Warns of a quaternion without a direction, 0 0 0 0, which transform_of takes for no rotation.
void warn_unless_rotation(const std::array<double, 4>& quaternion, const std::string& pointer,
                          GltfContext& context);

/// The poses of all nodes as the file has them. Throws Error where a matrix is projective, or a node has
/// both a matrix and one of the three.
std::vector<GltfPose> rest_poses(GltfDocument& document);

/// From the space of each node to the world. Throws Error unless the nodes form trees.
std::vector<Transform> world_transforms(GltfDocument& document, const std::vector<GltfPose>& poses);

/// The nodes of the scene that the file means, or of its first one, parents first. Without a scene those that
/// have no parent, with what is below them, which a warning says.
std::vector<int> shown_nodes(GltfDocument& document);

/// Of each node whether its mesh and its light are there: neither its own KHR_node_visibility nor that of a
/// node above hides it. Cameras are never hidden.
std::vector<bool> visible_nodes(GltfDocument& document);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// Primitives whose vertices move: towards morph targets, and with the joints of a skin.
#pragma once
#include <vector>

#include "core/transform.h"
#include "io/gltf/primitive.h"

namespace twinray {

struct GltfDeformation {
  std::vector<double> weights;    ///< Of morph targets; those that are missing are 0.
  std::vector<Transform> joints;  ///< From the mesh's space at rest to the world; none: no skin.

  /// Whether vertices stay where they are.
  bool is_none() const;
};

/// The matrices of a skin's joints, given from where each node is. Throws Error, with the place, where there
/// are less inverse bind matrices than joints.
std::vector<Transform> joint_transforms(GltfDocument& document, int skin,
                                        const std::vector<Transform>& world);

/// Whether joints mirror what they move, or most of them do.
bool are_mirrored(const std::vector<Transform>& joints);

/// The primitive with its vertices moved, first by the targets, then by the joints; with these it is in the
/// world. Throws Error, with the place, where a target has other counts or a vertex names a joint that is not
/// there.
GltfPrimitive deformed(GltfDocument& document, const GltfPrimitive& rest, const GltfDeformation& deformation);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "core/transform.h"

namespace twinray {

class GltfDocument;

/// Where a node's mesh stands: at the node or, with EXT_mesh_gpu_instancing, once for each of the extension's
/// transforms within it. Throws Error, with the place, where their numbers differ.
std::vector<Transform> instance_transforms(GltfDocument& document, int node, const Transform& to_world);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
// What moves a glTF file's nodes in time.
#pragma once
#include <optional>
#include <vector>

#include "io/gltf/nodes.h"

namespace twinray {

struct GltfContext;

/// From the first key of all of a file's animations to the last, in seconds.
struct GltfDuration {
  double first = 0, last = 0;
};

/// None where nothing moves.
std::optional<GltfDuration> duration_of(GltfDocument& document);

/// The poses at a time: translations, rotations, scales and weights of morph targets, as their keys and
/// interpolation say; before the first key of a channel and behind its last one they stand still. All
/// animations are applied; where several move the same the first one counts, with a warning. Throws Error,
/// with the place, where keys are not in order or values are not one for each of them.
void animate(GltfDocument& document, double seconds, std::vector<GltfPose>& poses);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "cli/replay/sample.h"
#include "io/obj/lines.h"

namespace twinray {

/// What can be seen of a path: "path" from the camera on, "light_samples" and "blocked_light_samples" of its
/// vertices, and "normals" on the viewer's side. A ray that leaves the scene is as long as the scene.
std::vector<LineObject> replay_lines(const ReplayedSample& replayed);

}  // namespace twinray

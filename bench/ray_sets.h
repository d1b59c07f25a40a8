// SPDX-License-Identifier: Apache-2.0
// Rays that a render really traces, recorded once for each scene and replayed to every engine alike.
#pragma once
#include <vector>

#include "core/scene.h"
#include "integrators/recorded_rays.h"

namespace twinray::bench {

/// How much of a render is recorded: CS184's usual picture, thinned out.
struct Recording {
  int width = 160, height = 120;
  std::uint32_t samples = 1;
  int max_depth = 5;
};

/// All rays of a path-traced picture of the scene (one light sample a hit), row by row. The same on every
/// machine.
std::vector<RecordedRay> record_rays(const Scene& scene, const Recording& recording = {});

/// The rays of one kind.
std::vector<Ray> rays_of_kind(const std::vector<RecordedRay>& recorded, RayKind kind);

}  // namespace twinray::bench

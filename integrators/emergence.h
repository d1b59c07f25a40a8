// SPDX-License-Identifier: Apache-2.0
// How a path gets into a body below a surface, and out again: the ends of a walk (integrators/walk_below.h).
#pragma once
#include "core/bsdf_table.h"
#include "core/ray_cone.h"
#include "integrators/interaction.h"
#include "integrators/walk_below.h"

namespace twinray {

/// Whether some of the light that arrives there goes below the surface.
bool goes_below(const Scene& scene, const Interaction& at);

/// The walk of a path that goes below a surface along `into`, which starts there, with this throughput; it is
/// in `interiors` still.
WalkBelow walk_from(const Scene& scene, const Interaction& from, const Ray& into, const Interiors& interiors,
                    const Rgb& throughput, const WalkDraws& draws);

/// Where a walk that began at `from` has come out. The cone around the last ray is followed to there; how the
/// path is viewed further on says `materials`.
Interaction come_out(const BsdfTable& bsdfs, const Interaction& from, const WalkEnd& end,
                     const VertexSampler& draws, Materials materials, RayCone& cone);

}  // namespace twinray

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/hit.h"
#include "core/ray_cone.h"
#include "core/sampler.h"
#include "core/scene.h"
#include "core/surface.h"

namespace twinray {

/// The point of a surface that a ray of this direction has hit, of any length, with what textures need to
/// know of it: where there are any, the cone around the ray is followed from the ray's origin to there.
SurfacePoint seen_point(const Scene& scene, const Hit& hit, const Vec3& direction,
                        const VertexSampler& sampler, RayCone& cone);

}  // namespace twinray
